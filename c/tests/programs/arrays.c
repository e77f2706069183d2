/* Arrays: the bits of one arch alone, whatever the threads and the order; rows that make no sense are rows. */

#include "test.h"

#define ALPHAS 12
#define MUS 15
#define N (ALPHAS * MUS)

static double half_opening[N], friction[N], thickness[N], values[2][3][N], others[2][3][N];
static uint8_t verdict[N], mode[N], verdict2[N], mode2[N];

static void grid(void) {
  for (int i = 0; i < N; i++) {
    half_opening[i] = 0.3 + 0.22 * (i % ALPHAS);
    friction[i] = 0.07 + 0.13 * (double)(i / ALPHAS);
    thickness[i] = 0.1 + 0.01 * (i % 7);
  }
  friction[N - 1] = INFINITY;
}

/* That row i is the answer to the question of its exact texts. */
static void is_alone(int i, const char *const *quantities, int with_thickness) {
  char alpha[1100], mu[1100], eta[1100];
  couplet_answer *answer;
  couplet_exact(half_opening[i], alpha, sizeof alpha);
  couplet_exact(friction[i], mu, sizeof mu);
  couplet_exact(thickness[i], eta, sizeof eta);
  int code = with_thickness ? couplet_assess("heyman", alpha, mu, eta, 17, &answer)
                            : couplet_state("heyman", alpha, mu, 17, &answer);
  IS(code == COUPLET_PROVED);
  SAYS(couplet_verdict(answer), verdict[i] == COUPLET_STANDS ? "stands" : "falls");
  if (!with_thickness) {
    SAYS(couplet_mode(answer), couplet_mode_name(mode[i]));
  }
  for (int q = 0; q < 2; q++) {
    double x, lower, upper;
    if (couplet_double(answer, quantities[q], &x, &lower, &upper) == COUPLET_PROVED) {
      IS(values[q][0][i] == x && values[q][1][i] <= x && x <= values[q][2][i]);
      IS(nextafter(values[q][1][i], upper) <= upper && lower <= nextafter(values[q][2][i], lower));
    } else {
      IS(isnan(values[q][0][i]) && isnan(values[q][1][i]) && isnan(values[q][2][i]));
    }
  }
  couplet_free(answer);
}

int main(void) {
  grid();
  for (int with = 0; with < 2; with++) {
    const double *etas = with ? thickness : NULL;
    const char *names = with ? "geometric_safety,least_thrust" : "thickness, thrust";
    const char *quantities[2] = {with ? "geometric_safety" : "thickness", with ? "least_thrust" : "thrust"};
    IS(couplet_states("heyman", N, half_opening, friction, etas, names, 1, verdict, mode, &values[0][0][0], NULL) ==
       COUPLET_PROVED);
    int stand = 0;
    for (int i = 0; i < N; i++) {
      stand += verdict[i] == COUPLET_STANDS;
      IS(!with || mode[i] == COUPLET_NO_MODE);
      is_alone(i, quantities, with);
    }
    IS(stand > 20 && stand < N - 20);
    const size_t threads[] = {0, 2, 7};
    for (int t = 0; t < 3; t++) {
      couplet_answer *answer;
      IS(couplet_states("heyman", N, half_opening, friction, etas, names, threads[t], verdict2, mode2, &others[0][0][0],
                        &answer) == COUPLET_PROVED);
      SAYS(couplet_verdict(answer), "proved");
      SAYS(couplet_reason(answer), "");
      couplet_free(answer);
      IS(memcmp(values, others, sizeof values) == 0 && memcmp(verdict, verdict2, N) == 0 && memcmp(mode, mode2, N) == 0);
    }
  }

  /* Bad rows, and good ones beside them. */
  couplet_answer *answer;
  half_opening[3] = NAN;
  friction[5] = -1;
  half_opening[7] = 3.2;
  half_opening[8] = -INFINITY;
  IS(couplet_states("heyman", N, half_opening, friction, NULL, "thickness,thrust", 2, verdict2, mode2, &others[0][0][0],
                    &answer) == COUPLET_OPEN);
  SAYS(couplet_reason(answer),
       "of 180 rows 4 refused; the first is row 3, counted from 0: 'NaN' is not a number: give a decimal (0.1), a fraction "
       "(1/3), a multiple of pi (2pi/3), or for an angle degrees (80deg)");
  couplet_free(answer);
  for (int i = 0; i < N; i++) {
    int bad = i == 3 || i == 5 || i == 7 || i == 8;
    IS((verdict2[i] == COUPLET_REFUSED) == bad);
    IS(!bad || (isnan(others[0][0][i]) && isnan(others[1][2][i]) && mode2[i] == COUPLET_NO_MODE));
  }
  puts("well");
  return 0;
}
