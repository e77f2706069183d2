/* Prints the JSON of the question that its arguments are: the function, and what it takes; "-" is what is not given. */

#include "test.h"

static char **words;

static const char *word(int place) { return strcmp(words[place], "-") == 0 ? NULL : words[place]; }

int main(int count, char **arguments) {
  IS(count > 4);
  words = arguments + 1;
  size_t digits = strtoul(words[count - 2], NULL, 10);
  couplet_answer *answer = NULL;
  if (strcmp(words[0], "state") == 0) {
    couplet_state(word(1), word(2), word(3), digits, &answer);
  } else if (strcmp(words[0], "assess") == 0) {
    couplet_assess(word(1), word(2), word(3), word(4), digits, &answer);
  } else if (strcmp(words[0], "any") == 0) {
    if (couplet_arch(word(1), word(2), digits, &answer) == COUPLET_USAGE) {
      puts(couplet_reason(answer));
    }
  } else if (strcmp(words[0], "find") == 0) {
    couplet_find(word(1), word(2), word(3), word(4), word(5), digits, &answer);
  } else if (strcmp(words[0], "landmark") == 0) {
    couplet_certify_landmark(word(1), word(2), digits, 1, &answer);
  } else if (strcmp(words[0], "arch") == 0) {
    couplet_certify_arch(word(1), word(2), word(3), word(4), digits, &answer);
  }
  IS(answer != NULL);
  fputs(couplet_json(answer), stdout);
  couplet_free(answer);
  return 0;
}
