/* A program with another library made by Rust. */

#include "test.h"

unsigned char other_catches(unsigned char length);

int main(void) {
  IS(other_catches(8) == 7 && other_catches(7) == 0);
  couplet_answer *answer;
  IS(couplet_state("milankovitch", "80deg", "0.25", 20, &answer) == COUPLET_PROVED);
  TELLS(couplet_text(answer, "thickness", COUPLET_VALUE), "0.10643650640572253656");
  couplet_free(answer);
  IS(other_catches(7) == 0);
  puts("well");
  return 0;
}
