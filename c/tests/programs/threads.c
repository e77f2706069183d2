/* Many threads with little stack ask at once, read one answer at once, and end; all see the same. */

#include "test.h"
#include <pthread.h>

#define THREADS 8
#define ROUNDS 20
#define STACK (256 * 1024)

static couplet_answer *shared;
static char constant[400], json[100000];

static void *ask(void *number) {
  for (int round = 0; round < ROUNDS; round++) {
    couplet_answer *answer;
    char mu[32];
    snprintf(mu, sizeof mu, "0.%d", 3 + (int)(size_t)number % 4);
    IS(couplet_state("heyman", "80deg", mu, round % 4 == 0 ? 60 : 17, &answer) == COUPLET_PROVED);
    IS(strlen(couplet_json(answer)) > 100);
    couplet_free(answer);
    IS(couplet_state("heyman", "800deg", mu, 17, &answer) == COUPLET_USAGE);
    TELLS(couplet_reason(answer), "800deg");
    couplet_free(answer);
    SAYS(couplet_text(shared, "thickness", COUPLET_VALUE), constant);
    SAYS(couplet_json(shared), json);
  }
  couplet_answer *all;
  IS(couplet_arch("heyman", "span=10m+-2cm; rise=3m+-1cm; thickness=60cm+-1cm; mu=0.5..0.6", 5, &all) == COUPLET_PROVED);
  SAYS(couplet_verdict(all), "all_stand");
  couplet_free(all);
  double one[4] = {1, 1.2, 1.4, 1.6}, values[12];
  uint8_t verdict[4];
  IS(couplet_states("heyman", 4, one, one, NULL, "thickness", 1 + (size_t)number % 3, verdict, NULL, values, NULL) ==
     COUPLET_PROVED);
  couplet_answer *answer;
  IS(couplet_constant("T", "heyman", "thickness", 300, 1 + (size_t)number % 2, &answer) == COUPLET_PROVED);
  SAYS(couplet_text(answer, "thickness", COUPLET_VALUE), constant);
  couplet_free(answer);
  return NULL;
}

int main(void) {
  couplet_answer *same;
  IS(couplet_constant("T", "heyman", "thickness", 300, 1, &same) == COUPLET_PROVED);
  strcpy(constant, couplet_text(same, "thickness", COUPLET_VALUE));
  IS(strlen(couplet_json(same)) < sizeof json);
  strcpy(json, couplet_json(same));
  couplet_free(same);
  /* Its JSON is made while all read it. */
  IS(couplet_constant("T", "heyman", "thickness", 300, 1, &shared) == COUPLET_PROVED);
  pthread_t threads[THREADS];
  pthread_attr_t small;
  IS(pthread_attr_init(&small) == 0 && pthread_attr_setstacksize(&small, STACK) == 0);
  for (size_t i = 0; i < THREADS; i++) {
    IS(pthread_create(&threads[i], &small, ask, (void *)i) == 0);
  }
  for (int i = 0; i < THREADS; i++) {
    IS(pthread_join(threads[i], NULL) == 0);
  }
  pthread_attr_destroy(&small);
  couplet_free(shared);
  puts("well");
  return 0;
}
