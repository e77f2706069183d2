/* Texts and bytes that somebody made to do harm, arrays and buffers that end where the memory does, eight threads at once: each
 * call comes back with a code and one sentence, and nothing is read or written beside what was given. With the argument `twice`
 * an answer is freed twice, which the caller promises not to do. */

#define _GNU_SOURCE
#include "test.h"
#include <pthread.h>
#include <sys/mman.h>
#include <unistd.h>

#define THREADS 8

static const char *const M = "milankovitch";

/* So many bytes behind which no memory can be touched, nor before the page where they begin. */
static char *at_the_edge(size_t size) {
  const size_t page = (size_t)sysconf(_SC_PAGESIZE), pages = (size + page - 1) / page * page;
  char *all = mmap(NULL, pages + 2 * page, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  IS(all != MAP_FAILED);
  IS(mprotect(all + page, pages, PROT_READ | PROT_WRITE) == 0);
  return all + page + pages - size;
}

static char *text_at_the_edge(const char *text) { return memcpy(at_the_edge(strlen(text) + 1), text, strlen(text) + 1); }

/* Whatever was asked: a code of a question, and one line that a terminal can show. */
static void is_told(int code, couplet_answer *answer) {
  IS(code == COUPLET_PROVED || code == COUPLET_OPEN || code == COUPLET_USAGE);
  IS(answer != NULL && couplet_verdict(answer)[0] != 0);
  const char *reason = couplet_reason(answer);
  IS(code != COUPLET_USAGE || reason[0] != 0);
  IS(strlen(reason) < 2000);
  for (const char *c = reason; *c != 0; c++) {
    if ((unsigned char)*c < 32 || *c == 127) {
      fprintf(stderr, "%s has the character %d\n", reason, *c);
      exit(1);
    }
  }
  IS(couplet_json(answer) != NULL);
  for (size_t k = 0; k < couplet_count(answer); k++) {
    const char *name = couplet_quantity(answer, k);
    IS(name[0] != 0 && couplet_text(answer, name, COUPLET_VALUE) != NULL);
  }
  couplet_free(answer);
}

#define TOLD(function, ...)                  \
  do {                                       \
    couplet_answer *answer = NULL;           \
    int code = function(__VA_ARGS__, &answer); \
    is_told(code, answer);                   \
  } while (0)

/* Each is given as every text of every question. */
static const char *const HOSTILE[] = {
    "", " ", "\t1\n", "1\n2", "1\r", "\x1b[2J1", "\x07", "\xe2\x80\xae" "1", "\xc2\x9b" "1", "\xef\xbb\xbf" "1", "\xed\xa0\x80",
    "\xf4\x90\x80\x80", "\xc0\x80", "%s%n%x", "../../etc/passwd", "'; --", "\"", "\\", "{}", "[]", "()", "((((((((((", "))))",
    "-0", "+1", "--1", "1e", "e1", "1e999999999999999999999", "1e-999999999999999999999", "1e1000", "-1e400", "0x1p3", "1_000",
    "1/0", "0/0", "1/-3", "-1/-3", "1//3", "1/2/3", "1/3e9999999", "nan", "NaN", "inf", "-inf", "+inf", "infinity", "null", "true",
    "pi", "pi/0", "pi/pi", "pipi", "-pi", "1e50pi", "pi/1e999999", "180deg", "0deg", "1e-900deg", "91deg", "degdeg", "deg", "1degrad",
    "tan(90deg)", "tan(tan(1))", "tan(", "tan()", "tan(1e300)", "1..", "..1", "..", "...", "1..2..3", "2..1", "1+-", "+-1", "1+-2",
    "1+-100%", "1\xc2\xb1" "1%", "1..inf", "0..pi", "1e-300..1e-299", "3..1e999", "inf..inf", "mu=", "=1", "==", ";;;;", "; ;",
    "alpha=1;mu=1;alpha=1", "alpha=1;mu=1;eta=1;eta=", "alpha=1; mu=1; stones=1e9", "span=1m;rise=1m;mu=1", "span=1e300km;rise=1m;mu=1",
    "alpha=1;mu=1;joints=1,1,1", "alpha=1;mu=1;tilt=inf", "T", "t", "T,T", "all", "rrr/rrr", "rrs/rsr/srr", "[r,r,s]", "/", "heyman",
    "HEYMAN", "milankovitch,heyman", "thickness", "thickness,thickness", ",", ",,,,", "eta,", "astro", "mpfr", "gmp"};

enum { MANY = sizeof HOSTILE / sizeof *HOSTILE };

static void hostile_texts(void) {
  for (int i = 0; i <= MANY; i++) {
    const char *x = i < MANY ? text_at_the_edge(HOSTILE[i]) : NULL;
    TOLD(couplet_state, x, "1", "1", 5);
    TOLD(couplet_state, M, x, "1", 5);
    TOLD(couplet_state, M, "1", x, 5);
    TOLD(couplet_assess, x, "1", "1", "1", 5);
    TOLD(couplet_assess, M, x, "1", "0.5", 5);
    TOLD(couplet_assess, M, "1", x, "0.5", 5);
    TOLD(couplet_assess, M, "1", "1", x, 5);
    TOLD(couplet_arch, x, "alpha=1;mu=1", 5);
    TOLD(couplet_arch, M, x, 5);
    TOLD(couplet_find, x, NULL, "1", NULL, NULL, 5);
    TOLD(couplet_find, M, x, NULL, "1", NULL, 5);
    TOLD(couplet_find, M, NULL, x, NULL, NULL, 5);
    TOLD(couplet_find, M, NULL, NULL, x, NULL, 5);
    TOLD(couplet_find, M, NULL, NULL, "1", x, 5);
    TOLD(couplet_constant, x, M, "eta", 5, 1);
    TOLD(couplet_constant, "L", x, "eta", 5, 1);
    TOLD(couplet_constant, "L", M, x, 5, 1);
    TOLD(couplet_certify_landmark, x, M, 5, 1);
    TOLD(couplet_certify_landmark, "L", x, 5, 1);
    TOLD(couplet_certify_arch, x, "1", "1", NULL, 5);
    TOLD(couplet_certify_arch, M, x, "1", NULL, 5);
    TOLD(couplet_certify_arch, M, "1", x, NULL, 5);
    TOLD(couplet_certify_arch, M, "1", "1", x, 5);
    TOLD(couplet_check, "{}", 2, x);
    TOLD(couplet_check, x, x == NULL ? 0 : strlen(x), NULL);
    const double one = 1;
    double values[3];
    uint8_t verdict;
    TOLD(couplet_states, x, 1, &one, &one, NULL, "eta", 1, &verdict, NULL, values);
    TOLD(couplet_states, M, 1, &one, &one, NULL, x == NULL || strlen(x) < 10 ? x : "eta", 1, &verdict, NULL, values);
    IS(couplet_copy(x, NULL, 0) == (x == NULL ? 0 : strlen(x)));
  }
}

/* A certificate cut anywhere, with a byte changed anywhere, of a wrong length: refused, or the same claim. */
static void hostile_bytes(void) {
  couplet_answer *answer;
  IS(couplet_certify_landmark("L", M, 10, 1, &answer) == COUPLET_PROVED);
  const char *json = couplet_json(answer);
  const size_t length = strlen(json);
  char *bytes = memcpy(at_the_edge(length), json, length);
  IS(couplet_check(bytes, length, NULL, NULL) == COUPLET_PROVED);
  for (size_t cut = 0; cut < length - 1; cut += 1 + length / 97) {
    IS(couplet_check(bytes + length - cut, cut, NULL, NULL) == COUPLET_OPEN);
    char *shorter = memcpy(at_the_edge(cut), json, cut);
    IS(couplet_check(shorter, cut, NULL, NULL) == COUPLET_OPEN);
  }
  for (size_t place = 0; place < length; place += 1 + length / 211) {
    const char before = bytes[place];
    const char changed[] = {0, '\xff', (char)(before ^ 1), '9'};
    bytes[place] = changed[place % 4];
    TOLD(couplet_check, bytes, length, NULL);
    bytes[place] = before;
  }
  IS(couplet_check(bytes, length, "mpfr", NULL) == COUPLET_PROVED);
  couplet_free(answer);
  const size_t deep = 1000000;
  char *nested = memset(at_the_edge(deep), '[', deep);
  TOLD(couplet_check, nested, deep, NULL);
}

/* Arrays of exactly as many values as are said, of every kind of number. */
static void arrays_at_the_edge(void) {
  const double odd[] = {0, -0.0, 1, -1, 2.5, 5e-324, 2e-308, 1e-300, 1e300, 1.7976931348623157e308, INFINITY, -INFINITY, NAN, 3.14159};
  enum { ODD = sizeof odd / sizeof *odd, ROWS = ODD * ODD };
  for (size_t n = 0; n <= ROWS; n += n < 70 ? 1 : 63) {
    double *alpha = (double *)(void *)at_the_edge(8 * n), *mu = (double *)(void *)at_the_edge(8 * n);
    double *values = (double *)(void *)at_the_edge(8 * 3 * n), *eta = (double *)(void *)at_the_edge(8 * n);
    uint8_t *verdict = (uint8_t *)at_the_edge(n), *mode = (uint8_t *)at_the_edge(n);
    for (size_t i = 0; i < n; i++) {
      alpha[i] = odd[i % ODD], mu[i] = odd[i / ODD], eta[i] = odd[(i + 2) % ODD];
    }
    TOLD(couplet_states, M, n, alpha, mu, NULL, "thickness", n % 3, verdict, mode, values);
    for (size_t i = 0; i < n; i++) {
      IS(verdict[i] <= COUPLET_REFUSED && (mode[i] < 7 || mode[i] == COUPLET_NO_MODE));
      IS((verdict[i] == COUPLET_STANDS) == !isnan(values[i]));
      IS(verdict[i] != COUPLET_STANDS || (values[n + i] <= values[i] && values[i] <= values[2 * n + i]));
      IS(verdict[i] == COUPLET_REFUSED || (alpha[i] > 0 && alpha[i] < 3.15 && mu[i] >= 0));
    }
    TOLD(couplet_states, M, n, alpha, mu, eta, "geometric_safety", 1, verdict, mode, values);
    TOLD(couplet_states, M, n, alpha, alpha, NULL, NULL, 1, verdict, NULL, NULL);
  }
  for (size_t i = 0; i < ODD; i++) {
    char *exact = at_the_edge(1100);
    const size_t length = couplet_exact(odd[i], exact, 1100);
    IS(length < 1100 && strlen(exact) == length);
    for (size_t size = 0; size <= length + 1; size += 1 + length / 7) {
      char *buffer = at_the_edge(size);
      IS(couplet_exact(odd[i], buffer, size) == length && couplet_copy(exact, buffer, size) == length);
      IS(size == 0 || strlen(buffer) == (size > length ? length : 0));
    }
  }
  for (int code = -300; code < 300; code++) {
    IS((couplet_mode_name(code)[0] != 0) == (code >= 0 && code < 7));
  }
}

static void *attack(void *which) {
  void (*const attacks[])(void) = {hostile_texts, hostile_bytes, arrays_at_the_edge, hostile_bytes};
  attacks[(size_t)which % 4]();
  return NULL;
}

int main(int count, char **arguments) {
  if (count > 1 && strcmp(arguments[1], "twice") == 0) {
    couplet_answer *answer;
    IS(couplet_state(M, "1", "1", 5, &answer) == COUPLET_PROVED);
    couplet_free(answer);
    couplet_free(answer);
    return 0;
  }
  pthread_t threads[THREADS];
  for (size_t i = 0; i < THREADS; i++) {
    IS(pthread_create(&threads[i], NULL, attack, (void *)i) == 0);
  }
  for (int i = 0; i < THREADS; i++) {
    IS(pthread_join(threads[i], NULL) == 0);
  }
  puts("well");
  return 0;
}
