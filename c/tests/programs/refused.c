/* What makes no sense comes back as a code with a sentence, and nothing else happens. */

#include "test.h"

/* A call that is refused, with words of its sentence; also if nobody wants the answer. */
#define REFUSED(words, function, ...)                         \
  do {                                                        \
    couplet_answer *answer = NULL;                            \
    IS(function(__VA_ARGS__, &answer) == COUPLET_USAGE);      \
    IS(answer != NULL);                                       \
    SAYS(couplet_verdict(answer), "refused");                 \
    TELLS(couplet_reason(answer), words);                     \
    SAYS(couplet_json(answer), "");                           \
    IS(couplet_count(answer) == 0);                           \
    couplet_free(answer);                                     \
    IS(function(__VA_ARGS__, NULL) == COUPLET_USAGE);         \
  } while (0)

static const char *const M = "milankovitch";

static void texts(void) {
  REFUSED("weight is NULL", couplet_state, NULL, "1", "1", 10);
  REFUSED("half_opening is NULL", couplet_state, M, NULL, "1", 10);
  REFUSED("friction is NULL", couplet_state, M, "1", NULL, 10);
  REFUSED("thickness is NULL", couplet_assess, M, "1", "1", NULL, 10);
  REFUSED("weight is not UTF-8", couplet_state, "\xff", "1", "1", 10);
  REFUSED("friction is not UTF-8", couplet_state, M, "1", "0.\xc3", 10);
  REFUSED("a weight is one of heyman, milankovitch", couplet_state, "haymann", "1", "1", 10);
  REFUSED("'' is not a number", couplet_state, M, "", "1", 10);
  REFUSED("has a comma", couplet_state, M, "1,4", "1", 10);
  REFUSED("divides by zero", couplet_state, M, "1/0", "1", 10);
  REFUSED("'nan' is not a number", couplet_state, M, "nan", "1", 10);
  REFUSED("not between 0 and pi", couplet_state, M, "4", "1", 10);
  REFUSED("not between 0 and pi", couplet_state, M, "0", "1", 10);
  REFUSED("is negative", couplet_state, M, "1", "-1", 10);
  REFUSED("not between 0 and pi/2", couplet_state, M, "1", "91deg", 10);
  REFUSED("is not between 0 and 2", couplet_assess, M, "1", "1", "2.5", 10);
  REFUSED("no ratio of thickness", couplet_assess, M, "1", "1", "5deg", 10);
  REFUSED("arch is NULL", couplet_arch, M, NULL, 10);
  REFUSED("half_opening, friction (or friction_angle) are missing", couplet_arch, M, "", 10);
  REFUSED("'colour' is none of the fields of an arch", couplet_arch, M, "colour=red", 10);
  REFUSED("friction is given twice", couplet_arch, M, "mu=1; friction=1", 10);
  REFUSED("span needs rise", couplet_arch, M, "span=10m; mu=1", 10);
  REFUSED("'10' is not a length", couplet_arch, M, "span=10; rise=3m; mu=1", 10);
  REFUSED("stones does not belong here: the command", couplet_arch, M, "alpha=1; mu=1; stones=7", 10);
  REFUSED("1.1..1 is empty: give the lower end first", couplet_state, M, "1.1..1", "1", 10);
  REFUSED("write 80deg..82deg", couplet_assess, M, "80..82deg", "1", "0.1", 10);
  REFUSED("2m..1m is empty", couplet_arch, M,
          "alpha=1; radius=5m+-1cm; eta=50cm; mu=1; density=24kN/m3; depth=2m..1m", 10);
  REFUSED("thickness is missing", couplet_certify_arch, M, "1..1.1", "1", NULL, 10);
  REFUSED("give one value here", couplet_find, M, NULL, "1..1.1", NULL, NULL, 10);
  char *one = malloc(1000001);
  memset(one, '1', 1000000);
  one[1000000] = 0;
  REFUSED("is too long", couplet_state, M, one, "1", 10);
  free(one);
}

static void digits(void) {
  const size_t wrong[] = {0, 1000001, 1000000000, (size_t)-1};
  for (int i = 0; i < 4; i++) {
    REFUSED("digits are a whole number from 1 to 1000000", couplet_state, M, "1", "1", wrong[i]);
    REFUSED("digits are a whole number from 1 to 1000000", couplet_assess, M, "1", "1", "1", wrong[i]);
    REFUSED("digits are a whole number from 1 to 1000000", couplet_find, M, NULL, "1", NULL, NULL, wrong[i]);
    REFUSED("digits are a whole number from 1 to 1000000", couplet_certify_arch, M, "1", "1", NULL, wrong[i]);
    REFUSED("digits are a whole number from 1 to 1000000", couplet_constant, "T", M, NULL, wrong[i], 1);
    REFUSED("digits are a whole number from 1 to 1000000", couplet_certify_landmark, "T", M, wrong[i], 1);
  }
}

static void landmarks(void) {
  REFUSED("landmark is NULL", couplet_constant, NULL, M, NULL, 10, 1);
  REFUSED("a landmark is one of T, S, J", couplet_constant, "X", M, NULL, 10, 1);
  REFUSED("a quantity is one of", couplet_constant, "T", M, "colour", 10, 1);
  REFUSED("there is no geometric_safety here", couplet_constant, "T", M, "eta,geometric_safety", 10, 1);
  REFUSED("quantity is not UTF-8", couplet_constant, "T", M, "\x80", 10, 1);
  REFUSED("threads are a whole number from 1 to 1024", couplet_constant, "T", M, NULL, 10, 1025);
  REFUSED("threads are a whole number", couplet_certify_landmark, "T", M, 10, (size_t)-1);
}

static void found(void) {
  REFUSED("give friction or half_opening", couplet_find, M, NULL, NULL, NULL, NULL, 10);
  REFUSED("give friction or half_opening", couplet_find, M, NULL, "1", "1", NULL, 10);
  REFUSED("give friction or half_opening", couplet_find, M, "rrs/rsr", "1", "1", NULL, 10);
  REFUSED("thickness does not belong here", couplet_find, M, "rrs/rsr", NULL, "1", "1", 10);
  REFUSED("needs a limited friction", couplet_find, M, "rrs/rsr", NULL, "inf", NULL, 10);
  REFUSED("not between 0 and pi", couplet_find, M, NULL, "4", NULL, NULL, 10);
  REFUSED("rrr", couplet_find, M, "rrr", NULL, "1", NULL, 10);
}

static void certificates(void) {
  couplet_answer *answer;
  REFUSED("certificate is NULL", couplet_check, NULL, 1, NULL);
  REFUSED("certificate has more values than there is memory", couplet_check, "{}", (size_t)-1, NULL);
  REFUSED("an arithmetic is one of astro, mpfr", couplet_check, "{}", 2, "gmp");
  /* No bytes, and others that are no certificate, are a verdict. */
  IS(couplet_check(NULL, 0, NULL, &answer) == COUPLET_OPEN);
  SAYS(couplet_verdict(answer), "refused");
  couplet_free(answer);
  IS(couplet_check("\xff\0\0", 3, "mpfr", &answer) == COUPLET_OPEN);
  TELLS(couplet_reason(answer), "not UTF-8");
  couplet_free(answer);
}

static void arrays(void) {
  const double one[2] = {1, 1};
  uint8_t verdict[4] = {77, 77, 77, 77}, mode[2] = {77, 77};
  double values[6] = {7, 7, 7, 7, 7, 7}, wide[8] = {1, 1, 1, 1, 1, 1, 1, 1};
  REFUSED("weight is NULL", couplet_states, NULL, 2, one, one, NULL, "eta", 1, verdict, mode, values);
  REFUSED("half_opening is NULL", couplet_states, M, 2, NULL, one, NULL, "eta", 1, verdict, mode, values);
  REFUSED("friction is NULL", couplet_states, M, 2, one, NULL, NULL, "eta", 1, verdict, mode, values);
  REFUSED("verdict is NULL", couplet_states, M, 2, one, one, NULL, "eta", 1, NULL, mode, values);
  REFUSED("values is NULL", couplet_states, M, 2, one, one, NULL, "eta", 1, verdict, mode, NULL);
  REFUSED("a quantity is one of", couplet_states, M, 2, one, one, NULL, "eta,", 1, verdict, mode, values);
  REFUSED("there is no friction here", couplet_states, M, 2, one, one, NULL, "mu", 1, verdict, mode, values);
  REFUSED("there is no thickness here", couplet_states, M, 2, one, one, one, "eta", 1, verdict, mode, values);
  REFUSED("threads are a whole number", couplet_states, M, 2, one, one, NULL, "eta", 2000, verdict, mode, values);
  REFUSED("more values than there is memory", couplet_states, M, (size_t)-1, one, one, NULL, "eta", 1, verdict, mode,
          values);
  REFUSED("more values than there is memory", couplet_states, M, (size_t)-1 / 24, one, one, NULL, "eta,h", 1, verdict, mode,
          values);
  const double *crooked = (const double *)((const char *)one + 1);
  REFUSED("friction is not where values of its type can be", couplet_states, M, 1, one, crooked, NULL, "eta", 1, verdict, mode,
          values);
  REFUSED("values and friction overlap", couplet_states, M, 2, one, wide + 5, NULL, "eta", 1, verdict, mode, wide);
  REFUSED("mode and verdict overlap", couplet_states, M, 2, one, one, NULL, "eta", 1, verdict, verdict + 1, values);
  /* Nothing was written. */
  IS(verdict[0] == 77 && mode[1] == 77 && values[0] == 7 && wide[0] == 1);
  /* No rows need no arrays, and no quantities no values. */
  IS(couplet_states(M, 0, NULL, NULL, NULL, "eta", 1, NULL, NULL, NULL, NULL) == COUPLET_PROVED);
  IS(couplet_states(M, 2, one, one, NULL, NULL, 1, verdict, NULL, NULL, NULL) == COUPLET_PROVED);
  IS(verdict[0] == COUPLET_STANDS && verdict[1] == COUPLET_STANDS && mode[0] == 77);
}

static void readers(void) {
  double value = 1, lower = 1, upper = 1;
  couplet_answer *answer;
  SAYS(couplet_verdict(NULL), "");
  SAYS(couplet_reason(NULL), "");
  SAYS(couplet_mode(NULL), "");
  SAYS(couplet_json(NULL), "");
  SAYS(couplet_quantity(NULL, 0), "");
  SAYS(couplet_text(NULL, "thickness", COUPLET_VALUE), "");
  IS(couplet_count(NULL) == 0);
  IS(couplet_double(NULL, "thickness", &value, &lower, &upper) == COUPLET_USAGE);
  IS(isnan(value) && isnan(lower) && isnan(upper));
  couplet_free(NULL);
  IS(couplet_state(M, "1", "1", 10, &answer) == COUPLET_PROVED);
  SAYS(couplet_quantity(answer, (size_t)-1), "");
  const int wrong[] = {-2, 2, 2147483647, -2147483647 - 1};
  for (int i = 0; i < 4; i++) {
    SAYS(couplet_text(answer, "thickness", wrong[i]), "");
  }
  SAYS(couplet_text(answer, NULL, 0), "");
  SAYS(couplet_text(answer, "\xff", 0), "");
  SAYS(couplet_text(answer, "colour", 0), "");
  IS(couplet_double(answer, "colour", &value, NULL, NULL) == COUPLET_USAGE);
  IS(couplet_double(answer, NULL, &value, NULL, NULL) == COUPLET_USAGE);
  value = 1;
  IS(couplet_double(answer, "geometric_safety", &value, NULL, NULL) == COUPLET_OPEN && isnan(value));
  IS(couplet_double(answer, "thickness", NULL, NULL, NULL) == COUPLET_PROVED);
  couplet_free(answer);
  /* A buffer that is too small gets no part of a number. */
  char small[4] = "xyz";
  IS(couplet_copy("0.12", small, sizeof small) == 4 && small[0] == 0);
  IS(couplet_copy(NULL, small, sizeof small) == 0 && couplet_copy("0.12", NULL, 9) == 4);
  IS(couplet_exact(0.1, small, sizeof small) == 34 && small[0] == 0);
  IS(couplet_exact(NAN, small, sizeof small) == 0 && couplet_exact(0.5, NULL, 0) == 3);
}

int main(void) {
  texts();
  digits();
  landmarks();
  found();
  certificates();
  arrays();
  readers();
  puts("well");
  return 0;
}
