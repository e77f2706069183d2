/* Every function answers, and what an answer has can be read. */

#include "test.h"

static const char *const M = "milankovitch";

static void state(void) {
  couplet_answer *answer;
  double value, lower, upper;
  IS(couplet_state(M, "2.45", "1.35", 17, &answer) == COUPLET_PROVED);
  SAYS(couplet_verdict(answer), "stands");
  SAYS(couplet_mode(answer), "[r,r,s]");
  SAYS(couplet_reason(answer), "");
  SAYS(couplet_note(answer), "");
  SAYS(couplet_text(answer, "thickness", COUPLET_VALUE), "0.65024378080138317");
  SAYS(couplet_text(answer, "eta", COUPLET_VALUE), "0.65024378080138317");
  TELLS(couplet_text(answer, "thickness", COUPLET_LOWER), "0.6502437808013831");
  TELLS(couplet_text(answer, "thickness", COUPLET_UPPER), "0.6502437808013831");
  IS(couplet_count(answer) == 7);
  SAYS(couplet_quantity(answer, 0), "thickness");
  SAYS(couplet_quantity(answer, 7), "");
  for (size_t i = 0; i < couplet_count(answer); i++) {
    IS(couplet_double(answer, couplet_quantity(answer, i), &value, &lower, &upper) == COUPLET_PROVED);
    IS(lower <= value && value <= upper && upper <= nextafter(nextafter(lower, 9), 9));
    double text = strtod(couplet_text(answer, couplet_quantity(answer, i), COUPLET_VALUE), NULL);
    IS(lower <= text && text <= upper);
  }
  TELLS(couplet_json(answer), "\"schema\": \"couplet.state/2\"");
  IS(couplet_json(answer) == couplet_json(answer));
  couplet_free(answer);

  /* A double is another number than its decimals, and has an exact text. */
  char alpha[1100], mu[1100];
  IS(couplet_exact(2.45, alpha, sizeof alpha) < sizeof alpha && couplet_exact(1.35, mu, sizeof mu) < sizeof mu);
  IS(couplet_state(M, alpha, mu, 17, &answer) == COUPLET_PROVED);
  SAYS(couplet_text(answer, "thickness", COUPLET_VALUE), "0.65024378080138357");
  couplet_free(answer);

  IS(couplet_assess(M, "80deg", "31", "0.1", 6, &answer) == COUPLET_PROVED);
  SAYS(couplet_verdict(answer), "stands");
  SAYS(couplet_note(answer), "the friction 31 is a coefficient; an angle of 31 degrees is written 31deg");
  couplet_free(answer);

  IS(couplet_state("heyman", "80deg", "0.1", 10, &answer) == COUPLET_PROVED);
  SAYS(couplet_verdict(answer), "falls");
  SAYS(couplet_mode(answer), "");
  SAYS(couplet_reason(answer), "sliding");
  SAYS(couplet_text(answer, "thickness", COUPLET_VALUE), "");
  couplet_free(answer);

  /* It stands, and an asymmetric mechanism is proved. */
  IS(couplet_assess(M, "2.3", "1.05", "0.55", 12, &answer) == COUPLET_PROVED);
  SAYS(couplet_verdict(answer), "stands");
  SAYS(couplet_text(answer, "asymmetric_thickness", COUPLET_VALUE), "0.583084449604");
  couplet_free(answer);
}

/* Nearer to a boundary than can be told: its friction to 10,000 digits. */
static void undecided(void) {
  couplet_answer *boundary, *answer;
  IS(couplet_state("heyman", "pi/2", "1", 10000, &boundary) == COUPLET_PROVED);
  const char *friction = couplet_text(boundary, "rotational_friction", COUPLET_VALUE);
  IS(strlen(friction) > 10000);
  IS(couplet_state("heyman", "pi/2", friction, 10, &answer) == COUPLET_OPEN);
  SAYS(couplet_verdict(answer), "undecided");
  SAYS(couplet_mode(answer), "");
  IS(strlen(couplet_reason(answer)) > 10 && couplet_count(answer) == 0);
  TELLS(couplet_json(answer), "\"between\": [");
  couplet_free(answer);
  IS(couplet_certify_arch("heyman", "pi/2", friction, NULL, 10, &answer) == COUPLET_OPEN);
  SAYS(couplet_verdict(answer), "undecided");
  SAYS(couplet_json(answer), "");
  couplet_free(answer);
  couplet_free(boundary);
}

static void assess(void) {
  couplet_answer *answer;
  double value;
  IS(couplet_assess(M, "80deg", "0.6", "0.12", 8, &answer) == COUPLET_PROVED);
  SAYS(couplet_verdict(answer), "stands");
  SAYS(couplet_text(answer, "geometric_safety", COUPLET_VALUE), "1.7479853");
  TELLS(couplet_json(answer), "\"limited_by\": \"intrados at the haunch\"");
  couplet_free(answer);
  IS(couplet_assess(M, "80deg", "0.6", "0.01", 8, &answer) == COUPLET_PROVED);
  SAYS(couplet_verdict(answer), "falls");
  couplet_free(answer);
  IS(couplet_assess(M, "80deg", "inf", "0.12", 8, &answer) == COUPLET_PROVED);
  SAYS(couplet_text(answer, "friction_safety", COUPLET_VALUE), "inf");
  IS(couplet_double(answer, "friction_safety", &value, NULL, NULL) == COUPLET_PROVED && isinf(value));
  couplet_free(answer);
}

static void measured(void) {
  couplet_answer *answer;
  double value;
  const char *arch = "span=10m; rise=3m; thickness=60cm; friction=0.6; density=24kN/m3; depth=1m";
  IS(couplet_arch(M, arch, 5, &answer) == COUPLET_PROVED);
  SAYS(couplet_verdict(answer), "stands");
  SAYS(couplet_text(answer, "least_thickness_m", COUPLET_VALUE), "0.14813");
  SAYS(couplet_text(answer, "weight_kn", COUPLET_VALUE), "185.73");
  TELLS(couplet_json(answer), "thickness 60cm = 0.100559 r");
  couplet_free(answer);
  IS(couplet_arch(M, "radius=5m; alpha=80deg; phi=31deg; measured_at=centreline", 5, &answer) == COUPLET_PROVED);
  IS(couplet_double(answer, "radius_m", &value, NULL, NULL) == COUPLET_PROVED && value == 5);
  couplet_free(answer);
}

/* Every arch inside ranges: there are bounds and no value. */
static void surveyed(void) {
  couplet_answer *answer, *one;
  double value, lower, upper;
  IS(couplet_assess(M, "79deg..81deg", "0.6+-10%", "0.1..0.12", 6, &answer) == COUPLET_PROVED);
  SAYS(couplet_verdict(answer), "all_stand");
  SAYS(couplet_reason(answer), "");
  SAYS(couplet_mode(answer), "[r,r,r]");
  TELLS(couplet_json(answer), "\"schema\": \"couplet.survey/1\"");
  IS(couplet_assess(M, "81deg", "0.54", "0.1", 17, &one) == COUPLET_PROVED);
  IS(couplet_count(answer) >= 4);
  for (size_t i = 0; i < couplet_count(answer); i++) {
    const char *name = couplet_quantity(answer, i);
    SAYS(couplet_text(answer, name, COUPLET_VALUE), "");
    IS(couplet_double(answer, name, &value, &lower, &upper) == COUPLET_PROVED && isnan(value));
    IS(lower <= strtod(couplet_text(answer, name, COUPLET_LOWER), NULL) && lower < upper);
    IS(upper >= strtod(couplet_text(answer, name, COUPLET_UPPER), NULL));
    IS(couplet_double(one, name, &value, NULL, NULL) == COUPLET_PROVED && lower <= value && value <= upper);
  }
  /* One end is the value of that arch, rounded outward. */
  IS(couplet_double(one, "geometric_safety", &value, NULL, NULL) == COUPLET_PROVED);
  IS(couplet_double(answer, "geometric_safety", NULL, &lower, NULL) == COUPLET_PROVED && value < lower * 1.00001);
  couplet_free(one);
  couplet_free(answer);

  IS(couplet_assess(M, "80deg+-1deg", "0.5..inf", "0.07", 4, &answer) == COUPLET_PROVED);
  SAYS(couplet_verdict(answer), "both_occur");
  SAYS(couplet_text(answer, "friction_safety", COUPLET_LOWER), "none");
  SAYS(couplet_text(answer, "friction_safety", COUPLET_UPPER), "inf");
  IS(couplet_double(answer, "friction_safety", NULL, &lower, &upper) == COUPLET_PROVED && isnan(lower) && isinf(upper));
  couplet_free(answer);

  IS(couplet_state("heyman", "79deg..81deg", "0.05..0.1", 6, &answer) == COUPLET_PROVED);
  SAYS(couplet_verdict(answer), "none_can_stand");
  SAYS(couplet_mode(answer), "");
  couplet_free(answer);

  IS(couplet_arch(M, "span=10m+-2cm; rise=3m+-1cm; thickness=60cm+-1cm; friction=31deg+-1deg", 5, &answer) == COUPLET_PROVED);
  SAYS(couplet_verdict(answer), "all_stand");
  SAYS(couplet_text(answer, "least_thickness_m", COUPLET_UPPER), "0.14998");
  couplet_free(answer);
}

static void found(void) {
  couplet_answer *answer;
  IS(couplet_find(M, NULL, NULL, "0.5", "0.2", 12, &answer) == COUPLET_PROVED);
  SAYS(couplet_verdict(answer), "found");
  SAYS(couplet_text(answer, "half_opening", COUPLET_VALUE), "1.76714465279");
  TELLS(couplet_reason(answer), "no wider one does");
  TELLS(couplet_json(answer), "couplet.find/1");
  couplet_free(answer);
  IS(couplet_find(M, NULL, "80deg", NULL, "0.1", 10, &answer) == COUPLET_PROVED);
  SAYS(couplet_text(answer, "friction", COUPLET_VALUE), "0.2573157331");
  couplet_free(answer);
  IS(couplet_find(M, "rrs/rsr", NULL, "1.6", NULL, 10, &answer) == COUPLET_PROVED);
  SAYS(couplet_mode(answer), "[r,r,s]/[r,s,r]");
  couplet_free(answer);
  IS(couplet_find(M, NULL, "80deg", NULL, "0.01", 10, &answer) == COUPLET_PROVED);
  SAYS(couplet_verdict(answer), "nothing");
  couplet_free(answer);
}

static void constant(void) {
  couplet_answer *answer;
  double value, lower, upper;
  IS(couplet_constant("T", M, "thickness", 40, 1, &answer) == COUPLET_PROVED);
  SAYS(couplet_verdict(answer), "proved");
  IS(couplet_count(answer) == 1);
  SAYS(couplet_text(answer, "thickness", COUPLET_VALUE), "0.6183182410743234463744322565170652733556");
  IS(couplet_double(answer, "thickness", &value, &lower, &upper) == COUPLET_PROVED);
  IS(lower <= value && value <= upper && lower < upper && value == 0.61831824107432344637);
  TELLS(couplet_json(answer), "couplet.constants/1");
  couplet_free(answer);
  IS(couplet_constant("triple", "heyman", NULL, 5, 0, &answer) == COUPLET_PROVED);
  IS(couplet_count(answer) == 13);
  SAYS(couplet_text(answer, "eta", COUPLET_VALUE), "0.67960");
  couplet_free(answer);
  /* So many digits that threads have work, and a text of all of them. */
  IS(couplet_constant("L", M, "A", 20000, 3, &answer) == COUPLET_PROVED);
  IS(strlen(couplet_text(answer, "A", COUPLET_VALUE)) >= 3);
  couplet_free(answer);
}

static void certificates(void) {
  couplet_answer *made, *checked;
  IS(couplet_certify_landmark("T", M, 20, 2, &made) == COUPLET_PROVED);
  const char *text = couplet_json(made);
  TELLS(text, "couplet.certificate/1");
  const char *engines[] = {NULL, "astro", "mpfr"};
  for (int i = 0; i < 3; i++) {
    IS(couplet_check(text, strlen(text), engines[i], &checked) == COUPLET_PROVED);
    SAYS(couplet_verdict(checked), "accepted");
    SAYS(couplet_text(checked, "thickness", COUPLET_VALUE), "0.61831824107432344637");
    SAYS(couplet_text(checked, "thickness", COUPLET_LOWER), "");
    TELLS(couplet_reason(checked), "T milankovitch");
    couplet_free(checked);
  }
  /* One digit is spoiled. */
  char *spoiled = malloc(strlen(text) + 1);
  strcpy(spoiled, text);
  char *digit = strstr(spoiled, "0.61831824107432344637") + 21;
  *digit = *digit == '6' ? '7' : '6';
  IS(couplet_check(spoiled, strlen(spoiled), NULL, &checked) == COUPLET_OPEN);
  SAYS(couplet_verdict(checked), "refused");
  IS(strlen(couplet_reason(checked)) > 10);
  couplet_free(checked);
  free(spoiled);
  couplet_free(made);

  const char *thicknesses[] = {NULL, "0.12", "0.01"};
  for (int i = 0; i < 3; i++) {
    IS(couplet_certify_arch(M, "80deg", "0.6", thicknesses[i], 10, &made) == COUPLET_PROVED);
    IS(couplet_check(couplet_json(made), strlen(couplet_json(made)), NULL, NULL) == COUPLET_PROVED);
    couplet_free(made);
  }

  IS(couplet_certify_arch(M, "78deg..80deg", "0.6", "0.1..0.12", 10, &made) == COUPLET_PROVED);
  IS(couplet_check(couplet_json(made), strlen(couplet_json(made)), NULL, &checked) == COUPLET_PROVED);
  TELLS(couplet_reason(checked), "all arches stand");
  IS(couplet_count(checked) == 0);
  couplet_free(checked);
  couplet_free(made);
}

/* The header is of the library that is loaded, and its macros are of one version. */
static void version(void) {
  char numbers[64];
  SAYS(couplet_version(), COUPLET_C_VERSION);
  snprintf(numbers, sizeof numbers, "%d.%d.%d", COUPLET_C_VERSION_MAJOR, COUPLET_C_VERSION_MINOR,
           COUPLET_C_VERSION_PATCH);
  SAYS(numbers, COUPLET_C_VERSION);
  IS(COUPLET_C_VERSION_NUMBER / 10000 == COUPLET_C_VERSION_MAJOR);
  IS(COUPLET_C_VERSION_NUMBER % 100 == COUPLET_C_VERSION_PATCH);
#if COUPLET_C_VERSION_NUMBER < 100
#error "the preprocessor compares versions"
#endif
}

int main(void) {
  version();
  state();
  undecided();
  assess();
  measured();
  surveyed();
  found();
  constant();
  certificates();
  puts("well");
  return 0;
}
