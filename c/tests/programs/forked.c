/* A process that has asked is forked, and both go on. Between two calls the library has no thread, and a question about one arch
 * never has. */

#define _POSIX_C_SOURCE 200809L
#include "test.h"
#include <dirent.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* The threads of this process; 1 where that cannot be told. */
static int threads(void) {
  DIR *tasks = opendir("/proc/self/task");
  if (tasks == NULL) {
    return 1;
  }
  int count = -2;
  while (readdir(tasks) != NULL) {
    count++;
  }
  closedir(tasks);
  return count;
}

static void ask(void) {
  const double alpha[6] = {1, 1, 1, 1, 1, 1.1}, mu[6] = {0.5, 0.6, 0.7, 0.8, 0.9, 1};
  double values[3 * 6];
  uint8_t verdict[6];
  couplet_answer *answer;
  const size_t digits[] = {17, 30, 10000};
  for (int i = 0; i < 3; i++) {
    IS(couplet_state("heyman", "80deg", "0.35", digits[i], &answer) == COUPLET_PROVED);
    couplet_free(answer);
    IS(couplet_assess("heyman", "80deg", "0.35", "0.2", digits[i] < 1000 ? digits[i] : 1000, &answer) == COUPLET_PROVED);
    couplet_free(answer);
    IS(couplet_assess("heyman", "79deg..81deg", "0.35..0.4", "0.2..0.3", digits[i] < 1000 ? digits[i] : 1000, &answer) ==
       COUPLET_PROVED);
    couplet_free(answer);
    IS(threads() == 1);
  }
  IS(couplet_arch("heyman", "span=10m..11m; rise=3m; thickness=60cm; mu=0.6", 4, &answer) == COUPLET_PROVED);
  couplet_free(answer);
  IS(threads() == 1);
  IS(couplet_find("milankovitch", "rrs/rsr", NULL, "1.6", NULL, 1000, &answer) == COUPLET_PROVED);
  couplet_free(answer);
  IS(couplet_certify_arch("heyman", "80deg", "0.35", "0.2", 1000, &answer) == COUPLET_PROVED);
  IS(couplet_check(couplet_json(answer), strlen(couplet_json(answer)), NULL, NULL) == COUPLET_PROVED);
  couplet_free(answer);
  IS(couplet_states("heyman", 6, alpha, mu, NULL, "thickness", 1, verdict, NULL, values, NULL) == COUPLET_PROVED);
  IS(threads() == 1);
  IS(couplet_states("heyman", 6, alpha, mu, NULL, "thickness", 3, verdict, NULL, values, NULL) == COUPLET_PROVED);
  IS(couplet_constant("T", "heyman", "eta", 6000, 3, &answer) == COUPLET_PROVED);
  couplet_free(answer);
  IS(couplet_certify_arch("heyman", "78deg..80deg", "0.6", "0.1..0.12", 17, &answer) == COUPLET_PROVED);
  couplet_free(answer);
  /* Those of the last call have ended, as far as the kernel has noticed. */
  for (int i = 0; threads() > 1 && i < 1000; i++) {
    struct timespec pause = {0, 1000000};
    nanosleep(&pause, NULL);
  }
  IS(threads() == 1);
}

int main(void) {
  ask();
  pid_t child = fork();
  IS(child >= 0);
  if (child == 0) {
    /* Whoever waits for a thread that is not there waits for ever. */
    alarm(60);
    ask();
    _exit(0);
  }
  int status;
  IS(waitpid(child, &status, 0) == child);
  IS(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  ask();
  puts("well");
  return 0;
}
