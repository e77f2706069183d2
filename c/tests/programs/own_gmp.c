/* A program with functions that have the names of GMP, MPFR and the allocation of Rust, and do something else. */

#include "test.h"

#define ANOTHER(name)                      \
  void name(void);                         \
  void name(void) {                        \
    fputs("called " #name "\n", stderr);   \
    exit(1);                               \
  }

ANOTHER(__gmpn_mul_1)
ANOTHER(__gmpn_add_n)
ANOTHER(__gmpn_mul)
ANOTHER(__gmpz_init)
ANOTHER(__gmpz_mul)
ANOTHER(__gmpz_clear)
ANOTHER(__gmpq_init)
ANOTHER(mpfr_init2)
ANOTHER(mpfr_add)
ANOTHER(mpfr_mul)
ANOTHER(mpfr_sin_cos)
ANOTHER(mpfr_clear)
ANOTHER(mpfr_free_cache2)
ANOTHER(rust_eh_personality)

int main(void) {
  couplet_answer *answer;
  IS(couplet_state("milankovitch", "80deg", "0.25", 200, &answer) == COUPLET_PROVED);
  TELLS(couplet_text(answer, "thickness", COUPLET_VALUE), "0.106436506405722536555");
  couplet_free(answer);
  IS(couplet_constant("T", "heyman", "eta", 3000, 2, NULL) == COUPLET_PROVED);
  puts("well");
  return 0;
}
