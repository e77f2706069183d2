\\ PARI/GP: Newton's method with precision doubling, on the three equations of triple.py.
\\
\\   METHOD=newton DIGITS=1000 gp -q -f -s 256M pari.gp          print the six unknowns
\\   METHOD=newton DIGITS=1000 TIME=1 gp -q -f -s 256M pari.gp   warm up, time, one line of JSON
\\
\\ METHOD=bare is the yardstick: sines and cosines of the three angles. exp(I x) is GP's only way to
\\ have both at once, and costs as much as one of them.

START = [2.430, 1.043, 0.3187];
START_BITS = 50;
LOST = 4;
GUARD = 8;

bits_of(digits) = digits * 3322 \ 1000 + 1;
short(x, bits) = apply(y -> bitprecision(y, bits), x);

\\ cos and sin of alpha, beta and gamma, h, eta.
at(angles) =
{
  my([a, b, s] = angles, u = exp(I*a), v = exp(I*b), w = exp(I*(a + s)), h, q);
  h = (1 - sqrt(1 - 4*s^2))/2;
  q = a*imag(u)/(1 - real(u)) - h;
  [real(u), imag(u), real(v), imag(v), real(w), imag(w), h, 3*q - sqrt(9*q^2 - 12*(1 - q))];
}

reduced(angles, here) =
{
  my([a, b, s] = angles, [ca, sa, cb, sb, cg, sg, h, eta] = here, fac2 = 2 + eta^2/6, inner = 2 - eta);
  [ (h*s - a*(1 - h))*sg - s*(a + s)*cg,
    (fac2 - inner*(1 - h))*sb - inner*b*cb,
    (2 + eta)*h + fac2 - (inner*h + fac2)*cb - inner*b*sb ]~;
}

friction(a, here) =
{
  my([ca, sa, cb, sb, cg, sg, h, eta] = here);
  (h*sa - a*ca)/(h*ca + a*sa);
}

\\ The Newton step of the angles, and what belongs to it of eta, h and mu.
correction(angles, here, values) =
{
  my([a, b, s] = angles, [ca, sa, cb, sb, cg, sg, h, eta] = here, fac2 = 2 + eta^2/6, inner = 2 - eta,
     gamma = a + s, h_s = 2*s/(1 - 2*h), eta_q = (2 + eta)/(eta/3 - fac2/(2 + eta)),
     eta_a = eta_q*(sa - a)/(1 - ca), eta_s = -eta_q*h_s, p = h*s - a*(1 - h),
     r2_eta = (1 - h + eta/3)*sb + b*cb, r3_eta = h + eta/3 - (eta/3 - h)*cb + b*sb, jacobian, step, d, mu);
  jacobian = [
    (p - s)*cg + (s*gamma - (1 - h))*sg, 0, (p - gamma - s)*cg + (h + h_s*gamma + s*gamma)*sg;
    r2_eta*eta_a, (fac2 - inner*(2 - h))*cb + inner*b*sb, inner*sb*h_s + r2_eta*eta_s;
    r3_eta*eta_a, (inner*(h - 1) + fac2)*sb - inner*b*cb, (2 + eta - inner*cb)*h_s + r3_eta*eta_s ];
  step = matsolve(jacobian, values);
  d = h*ca + a*sa;
  mu = (h*sa - a*ca)/d;
  [ step~,
    [ eta_a*step[1] + eta_s*step[3],
      h_s*step[3],
      ((h*ca - ca + a*sa - mu*(sa + a*ca - h*sa))*step[1] + (sa - mu*ca)*h_s*step[3])/d ] ];
}

\\ Angles in START's precision, all it is given.
root(bits) =
{
  my(steps = List([bits]), angles, here, values, step, others, low);
  while (steps[#steps]\2 + LOST > START_BITS, listput(steps, steps[#steps]\2 + LOST));
  angles = short(START, 64);
  for (k = 1, 3, here = at(angles); angles -= correction(angles, here, reduced(angles, here))[1]);
  forstep (k = #steps, 1, -1,
    angles = short(angles, steps[k]);
    here = at(angles);
    low = steps[k]\2 + LOST;
    values = short(reduced(angles, here), low);
    [step, others] = correction(short(angles, low), short(here, low), values);
    if (k > 1, angles -= step);
  );
  concat(angles - step, [here[8], here[7], friction(angles[1], here)] - others);
}

bare(angles) = apply(x -> exp(I*x), angles);

cpu(job, calls) =
{
  my(start = getabstime());
  for (k = 1, calls, job());
  (getabstime() - start)/1000.;
}

\\ As harness.py: a first call to warm up, then the median of samples of 0.1 s or more (GP's clock counts in ms).
measure(job) =
{
  my(first = cpu(job, 1), calls = 1, samples = List(), spent = 0, t);
  if (first > 20, return([first, 0]));
  while (cpu(job, calls) < .1, calls *= 2);
  while (#samples < 7 && spent < 60, t = cpu(job, calls); spent += t; listput(samples, t/calls));
  [vecsort(samples)[(#samples + 1)\2], 1];
}

{
  my(method = getenv("METHOD"), digits = eval(getenv("DIGITS")), bits = bits_of(digits) + GUARD, job, seconds, warm,
     names = ["half_opening", "rotation_joint", "sliding_joint", "thickness", "thrust", "friction"], values, angles);
  default(realbitprecision, bits);
  values = root(bits);
  if (method == "bare", angles = values[1..3]; job = () -> bare(angles), job = () -> root(bits));
  if (getenv("TIME"), [seconds, warm] = measure(job));
  default(realprecision, digits);
  if (getenv("TIME"),
    printf("{\"seconds\": %.9f, \"warm\": %s, \"values\": [", seconds, if (warm, "true", "false"));
    for (k = 1, 6, print1(if (k > 1, ", ", ""), "\"", values[k], "\""));
    print("]}"),
    for (k = 1, 6, print(names[k], " ", values[k])));
}
