/* One arch as exact text, a question that makes no sense, and many arches as doubles.
 *
 *     cc arches.c -I target/c/include -L target/c/lib -lcouplet_c -Wl,-rpath,target/c/lib -o arches
 */

#include <couplet_c.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#define N 5

static uint64_t bits(double x) {
  uint64_t n;
  memcpy(&n, &x, sizeof n);
  return n;
}

int main(void) {
  couplet_answer *answer;

  /* The least thickness, to 40 digits, and its bounds as doubles. */
  if (couplet_state("milankovitch", "80deg", "0.25", 40, &answer) != COUPLET_PROVED) {
    fprintf(stderr, "%s\n", couplet_reason(answer));
    return 1;
  }
  double value, lower, upper;
  couplet_double(answer, "thickness", &value, &lower, &upper);
  if (!(lower <= value && value <= upper && lower < upper)) {
    return 1;
  }
  printf("%s %s\n", couplet_mode(answer), couplet_text(answer, "thickness", COUPLET_VALUE));
  couplet_free(answer);

  /* What makes no sense has a sentence. */
  if (couplet_state("milankovitch", "4", "0.25", 40, &answer) != COUPLET_USAGE) {
    return 1;
  }
  puts(couplet_reason(answer));
  couplet_free(answer);

  /* Many arches: a row that makes no sense is a row. */
  const double half_opening[N] = {0.5, 1.375, 1.375, 2.4375, 4.0};
  const double friction[N] = {0.5, 0.0625, 0.25, 1.375, 0.5};
  uint8_t verdict[N], mode[N];
  double values[2][3][N];
  int code = couplet_states("milankovitch", N, half_opening, friction, NULL, "thickness,thrust", 1, verdict, mode,
                            &values[0][0][0], NULL);
  if (code != COUPLET_OPEN) {
    return 1;
  }
  for (int i = 0; i < N; i++) {
    printf("%d %s", verdict[i], couplet_mode_name(mode[i]));
    if (verdict[i] == COUPLET_STANDS) {
      printf(" %016" PRIx64 " %016" PRIx64, bits(values[0][0][i]), bits(values[1][0][i]));
    }
    printf("\n");
  }
  return 0;
}
