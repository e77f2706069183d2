% One arch as exact text, a question that makes no sense, and many arches as doubles; beside couplet_state.oct and
% couplet_states.oct.
1;

% The least thickness, to 40 digits.
[mode, text] = couplet_state("milankovitch", "80deg", "0.25", 40);
printf("%s %s\n", mode, text);

% What makes no sense has a sentence.
try
  couplet_state("milankovitch", "4", "0.25", 40);
  assert(false);
catch wrong
  printf("%s\n", strrep(wrong.message, "couplet: ", ""));
end

% Many arches: a row that makes no sense is a row.
half_opening = [0.5, 1.375, 1.375, 2.4375, 4.0];
friction = [0.5, 0.0625, 0.25, 1.375, 0.5];
[verdict, mode, values] = couplet_states("milankovitch", half_opening, friction, "thickness,thrust");
for i = 1:numel(half_opening)
  printf("%d %s", verdict(i), mode{i});
  if verdict(i) == 0
    assert(values(i, 2, 1) <= values(i, 1, 1) && values(i, 1, 1) <= values(i, 3, 1));
    printf(" %s %s", num2hex(values(i, 1, 1)), num2hex(values(i, 1, 2)));
  end
  printf("\n");
end
