/* What the programs have in common: the first thing that is not so ends them. */

#ifndef TEST_H
#define TEST_H

#include <couplet_c.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define IS(condition)                                                    \
  do {                                                                   \
    if (!(condition)) {                                                  \
      fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition);    \
      exit(1);                                                           \
    }                                                                    \
  } while (0)

/* That two texts are the same. */
#define SAYS(text, words)                                                                \
  do {                                                                                   \
    const char *said = (text);                                                           \
    if (strcmp(said, (words)) != 0) {                                                    \
      fprintf(stderr, "%s:%d: %s says: %s\n", __FILE__, __LINE__, #text, said);          \
      exit(1);                                                                           \
    }                                                                                    \
  } while (0)

/* That a text has words in it. */
#define TELLS(text, words)                                                               \
  do {                                                                                   \
    const char *said = (text);                                                           \
    if (strstr(said, (words)) == NULL) {                                                 \
      fprintf(stderr, "%s:%d: %s says: %s\n", __FILE__, __LINE__, #text, said);          \
      exit(1);                                                                           \
    }                                                                                    \
  } while (0)

#endif
