/* Arb from C: the job of arb.py, by the same equations, without Python between its operations.
 *
 *     arb METHOD DIGITS     warm up, time, one line of JSON, as couplet.rs
 *
 * newton, proof, quantities and bare as in arb.py; enclosures is quantities without decimals. One thread; CPU time.
 *
 * The library is that of python-flint's wheel, which comes without headers: what is called is declared here. run.py
 * compiles it.
 */

#define _POSIX_C_SOURCE 199309L

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef long slong;
typedef unsigned long ulong;

/* A ball of Arb: six words of which nothing is read here. */
typedef struct {
    slong words[6];
} arb_struct;
typedef arb_struct arb_t[1];
typedef arb_struct *arb_ptr;
typedef const arb_struct *arb_srcptr;

void arb_init(arb_t);
void arb_set(arb_t, const arb_t);
void arb_set_d(arb_t, double);
void arb_set_round(arb_t, const arb_t, slong);
void arb_get_mid_arb(arb_t, const arb_t);
void arb_zero(arb_t);
void arb_neg(arb_t, const arb_t);
void arb_add(arb_t, const arb_t, const arb_t, slong);
void arb_add_ui(arb_t, const arb_t, ulong, slong);
void arb_sub(arb_t, const arb_t, const arb_t, slong);
void arb_sub_ui(arb_t, const arb_t, ulong, slong);
void arb_mul(arb_t, const arb_t, const arb_t, slong);
void arb_mul_ui(arb_t, const arb_t, ulong, slong);
void arb_mul_2exp_si(arb_t, const arb_t, slong);
void arb_addmul(arb_t, const arb_t, const arb_t, slong);
void arb_submul(arb_t, const arb_t, const arb_t, slong);
void arb_div(arb_t, const arb_t, const arb_t, slong);
void arb_div_ui(arb_t, const arb_t, ulong, slong);
void arb_ui_div(arb_t, ulong, const arb_t, slong);
void arb_inv(arb_t, const arb_t, slong);
void arb_sqrt(arb_t, const arb_t, slong);
void arb_sin_cos(arb_t, arb_t, const arb_t, slong);
void arb_cot(arb_t, const arb_t, slong);
void arb_atan(arb_t, const arb_t, slong);
void arb_const_pi(arb_t, slong);
void arb_add_error_2exp_si(arb_t, slong);
int arb_contains_interior(const arb_t, const arb_t);
int arb_is_positive(const arb_t);
char *arb_get_str(const arb_t, slong, ulong);
void flint_free(void *);
void flint_set_num_threads(int);

/* A format of decimals. */
#define NO_RADIUS 2

/* As in arb.py and triple.py. */
#define GUARD 8
#define PROOF_GUARD 32
#define LOST 4
#define START_BITS 50
/* The three angles as `floats` of triple.py gives them, from its four digits. */
static const double START[3] = {2.4300691037693487, 1.0425568085935986, 0.3187321853045027};

/* As in harness.py. */
#define SAMPLE 0.05
#define SAMPLES 7
#define BUDGET 60.0

/* Bits of an operation. */
static slong bits;

static void add(arb_t z, const arb_t x, const arb_t y) { arb_add(z, x, y, bits); }
static void sub(arb_t z, const arb_t x, const arb_t y) { arb_sub(z, x, y, bits); }
static void mul(arb_t z, const arb_t x, const arb_t y) { arb_mul(z, x, y, bits); }
static void quo(arb_t z, const arb_t x, const arb_t y) { arb_div(z, x, y, bits); }
static void plus(arb_t z, const arb_t x, ulong n) { arb_add_ui(z, x, n, bits); }
static void less(arb_t z, const arb_t x, ulong n) { arb_sub_ui(z, x, n, bits); }
static void more_by(arb_t z, const arb_t x, const arb_t y) { arb_addmul(z, x, y, bits); }
static void less_by(arb_t z, const arb_t x, const arb_t y) { arb_submul(z, x, y, bits); }

/* n - x */
static void from(arb_t z, ulong n, const arb_t x) {
    less(z, x, n);
    arb_neg(z, z);
}

/* Everything at a point: the angles; cosine and sine of alpha, of beta and of gamma = alpha + beta_s; h and eta. */
enum { ALPHA, BETA, BETA_S, CA, SA, CB, SB, CG, SG, H, ETA, POINT };
/* The unknowns, in the order of triple.py, and what follows from them. */
enum { UNKNOWNS = 6, QUANTITIES = 13 };

/* Room for what is computed on the way. */
static arb_struct room[20], matrices[64], points[3 * POINT];
static arb_ptr centre = points, lower = points + POINT, box = points + 2 * POINT;
static arb_ptr jacobian = matrices, gradients = matrices + 9, preconditioner = matrices + 18, residuals = matrices + 27,
               step = matrices + 30, others = matrices + 33, middle = matrices + 36;

static void start(void) {
    for (size_t i = 0; i < sizeof room / sizeof *room; i++) arb_init(room + i);
    for (size_t i = 0; i < sizeof matrices / sizeof *matrices; i++) arb_init(matrices + i);
    for (size_t i = 0; i < sizeof points / sizeof *points; i++) arb_init(points + i);
}

static void rounded(arb_ptr to, arb_srcptr x) {
    for (int i = 0; i < POINT; i++) arb_set_round(to + i, x + i, bits);
}

/* h = (1 - sqrt(1 - 4 beta_s^2))/2; eta = 3q - sqrt(9q^2 - 12(1 - q)), q = alpha cot(alpha/2) - h */
static void eliminated(arb_ptr at) {
    arb_ptr root = room, q = room + 1, rest = room + 2;
    mul(root, at + BETA_S, at + BETA_S);
    arb_mul_2exp_si(root, root, 2);
    from(root, 1, root);
    arb_sqrt(root, root, bits);
    from(root, 1, root);
    arb_mul_2exp_si(at + H, root, -1);
    mul(q, at + ALPHA, at + SA);
    from(rest, 1, at + CA);
    quo(q, q, rest);
    sub(q, q, at + H);
    mul(root, q, q);
    arb_mul_ui(root, root, 9, bits);
    less(rest, q, 1);
    arb_mul_ui(rest, rest, 12, bits);
    add(root, root, rest);
    arb_sqrt(root, root, bits);
    arb_mul_ui(q, q, 3, bits);
    sub(at + ETA, q, root);
}

static void evaluate(arb_ptr at) {
    arb_sin_cos(at + SA, at + CA, at + ALPHA, bits);
    arb_sin_cos(at + SB, at + CB, at + BETA, bits);
    add(room, at + ALPHA, at + BETA_S);
    arb_sin_cos(at + SG, at + CG, room, bits);
    eliminated(at);
}

/* fac2 = 2 + eta^2/6, inner = 2 - eta */
static void factors(arb_t fac2, arb_t inner, arb_srcptr at) {
    mul(fac2, at + ETA, at + ETA);
    arb_div_ui(fac2, fac2, 6, bits);
    plus(fac2, fac2, 2);
    from(inner, 2, at + ETA);
}

/* R1, R2 and R3 of triple.py */
static void reduced(arb_ptr r, arb_srcptr at) {
    arb_ptr fac2 = room, inner = room + 1, x = room + 2, y = room + 3, lean = room + 4;
    factors(fac2, inner, at);
    mul(x, at + H, at + BETA_S);
    less(y, at + H, 1);
    more_by(x, at + ALPHA, y);
    mul(r, x, at + SG);
    add(y, at + ALPHA, at + BETA_S);
    mul(y, y, at + BETA_S);
    less_by(r, y, at + CG);
    mul(lean, inner, at + BETA);
    less(x, at + H, 1);
    mul(x, x, inner);
    add(x, x, fac2);
    mul(r + 1, x, at + SB);
    less_by(r + 1, lean, at + CB);
    mul(y, inner, at + H);
    add(y, y, fac2);
    mul(y, y, at + CB);
    plus(x, at + ETA, 2);
    mul(x, x, at + H);
    add(x, x, fac2);
    sub(r + 2, x, y);
    less_by(r + 2, lean, at + SB);
}

/* mu = (h sin alpha - alpha cos alpha)/(h cos alpha + alpha sin alpha), over what is left in `denominator` */
static void friction(arb_t mu, arb_t denominator, arb_srcptr at) {
    mul(mu, at + H, at + SA);
    less_by(mu, at + ALPHA, at + CA);
    mul(denominator, at + H, at + CA);
    more_by(denominator, at + ALPHA, at + SA);
    quo(mu, mu, denominator);
}

/* The Jacobian of `reduced` and the gradients of eta, h and mu, by the angles, as `slopes` of triple.py. */
static void slopes(arb_ptr j, arb_ptr g, arb_srcptr at) {
    arb_ptr fac2 = room, inner = room + 1, gamma = room + 2, h_s = room + 3, rise = room + 4, eta_q = room + 5,
            eta_a = g, eta_s = g + 2, p = room + 6, x = room + 7, y = room + 8, lean = room + 9, r_h = room + 10,
            r_eta = room + 11, third = room + 12, mu = room + 13, denominator = room + 14;
    factors(fac2, inner, at);
    add(gamma, at + ALPHA, at + BETA_S);
    from(rise, 1, at + H);
    arb_div_ui(third, at + ETA, 3, bits);
    arb_mul_2exp_si(x, at + H, 1);
    from(x, 1, x);
    arb_mul_2exp_si(y, at + BETA_S, 1);
    quo(h_s, y, x);
    plus(x, at + ETA, 2);
    quo(y, fac2, x);
    sub(y, third, y);
    quo(eta_q, x, y);
    sub(x, at + SA, at + ALPHA);
    from(y, 1, at + CA);
    quo(x, x, y);
    mul(eta_a, eta_q, x);
    arb_zero(g + 1);
    mul(eta_s, eta_q, h_s);
    arb_neg(eta_s, eta_s);
    /* R1 */
    mul(p, at + H, at + BETA_S);
    less_by(p, at + ALPHA, rise);
    mul(lean, at + BETA_S, gamma);
    sub(x, p, at + BETA_S);
    mul(j, x, at + CG);
    sub(y, lean, rise);
    more_by(j, y, at + SG);
    arb_zero(j + 1);
    sub(x, x, gamma);
    mul(j + 2, x, at + CG);
    mul(y, h_s, gamma);
    add(y, y, at + H);
    add(y, y, lean);
    more_by(j + 2, y, at + SG);
    /* R2 */
    mul(lean, inner, at + BETA);
    mul(r_h, inner, at + SB);
    add(x, rise, third);
    mul(r_eta, x, at + SB);
    more_by(r_eta, at + BETA, at + CB);
    mul(j + 3, r_eta, eta_a);
    less(x, at + H, 2);
    mul(x, x, inner);
    add(x, x, fac2);
    mul(j + 4, x, at + CB);
    more_by(j + 4, lean, at + SB);
    mul(j + 5, r_h, h_s);
    more_by(j + 5, r_eta, eta_s);
    /* R3 */
    plus(r_h, at + ETA, 2);
    less_by(r_h, inner, at + CB);
    add(r_eta, at + H, third);
    sub(x, third, at + H);
    less_by(r_eta, x, at + CB);
    more_by(r_eta, at + BETA, at + SB);
    mul(j + 6, r_eta, eta_a);
    mul(x, inner, rise);
    sub(x, fac2, x);
    mul(j + 7, x, at + SB);
    less_by(j + 7, lean, at + CB);
    mul(j + 8, r_h, h_s);
    more_by(j + 8, r_eta, eta_s);
    /* h and mu */
    arb_zero(g + 3);
    arb_zero(g + 4);
    arb_set(g + 5, h_s);
    friction(mu, denominator, at);
    mul(x, at + ALPHA, at + SA);
    less_by(x, rise, at + CA);
    mul(y, rise, at + SA);
    more_by(y, at + ALPHA, at + CA);
    less_by(x, mu, y);
    quo(g + 6, x, denominator);
    arb_zero(g + 7);
    arb_set(y, at + SA);
    less_by(y, mu, at + CA);
    quo(y, y, denominator);
    mul(g + 8, y, h_s);
}

/* a d - b c */
static void minor_of(arb_t z, const arb_t a, const arb_t b, const arb_t c, const arb_t d) {
    mul(z, a, d);
    less_by(z, b, c);
}

/* The inverse of a matrix whose entry (0, 1) is zero. */
static void inverse(arb_ptr y, arb_srcptr m) {
    arb_ptr over = room, x = room + 1;
    minor_of(y, m + 4, m + 5, m + 7, m + 8);
    minor_of(y + 3, m + 5, m + 3, m + 8, m + 6);
    minor_of(y + 6, m + 3, m + 4, m + 6, m + 7);
    mul(over, m, y);
    more_by(over, m + 2, y + 6);
    arb_inv(over, over, bits);
    mul(y + 1, m + 2, m + 7);
    mul(y + 2, m + 2, m + 4);
    arb_neg(y + 2, y + 2);
    minor_of(y + 4, m, m + 2, m + 6, m + 8);
    minor_of(x, m, m + 2, m + 3, m + 5);
    arb_neg(y + 5, x);
    mul(y + 7, m, m + 7);
    arb_neg(y + 7, y + 7);
    mul(y + 8, m, m + 4);
    for (int i = 0; i < 9; i++) mul(y + i, y + i, over);
}

static void product(arb_ptr r, arb_srcptr m, arb_srcptr v) {
    for (int i = 0; i < 3; i++) {
        mul(r + i, m + 3 * i, v);
        more_by(r + i, m + 3 * i + 1, v + 1);
        more_by(r + i, m + 3 * i + 2, v + 2);
    }
}

/* Newton's method with precision doubling, as `newton` of triple.py: the angles; what belongs to those before the last step
   stays beside them, and is `mu` where that is asked for. */
static void newton(slong goal, arb_ptr mu) {
    slong levels[64];
    int count = 0;
    for (slong level = goal;; level = level / 2 + LOST) {
        levels[count++] = level;
        if (level / 2 + LOST <= START_BITS) break;
    }
    for (int i = 0; i < 3; i++) arb_set_d(centre + i, START[i]);
    while (count-- > 0) {
        bits = levels[count];
        evaluate(centre);
        reduced(residuals, centre);
        if (mu && count == 0) friction(mu, room, centre);
        bits = bits / 2 + LOST;
        rounded(lower, centre);
        slopes(jacobian, gradients, lower);
        inverse(preconditioner, jacobian);
        product(step, preconditioner, residuals);
        bits = levels[count];
        for (int i = 0; i < 3; i++) {
            sub(centre + i, centre + i, step + i);
            arb_get_mid_arb(centre + i, centre + i);
        }
    }
}

/* Newton's method for all six unknowns: the other three move along. */
static bool newton_of_all(arb_ptr out, slong goal) {
    newton(goal, out + 5);
    product(others, gradients, step);
    for (int i = 0; i < 3; i++) arb_set(out + i, centre + i);
    sub(out + 3, centre + ETA, others);
    sub(out + 4, centre + H, others + 1);
    sub(out + 5, out + 5, others + 2);
    return true;
}

/* The physical range, and no denominator that the equations have lost contains zero. */
static bool is_admissible(void) {
    arb_ptr x = room, s = room + 1, c = room + 2;
    bits = 53;
    bool is = arb_is_positive(box + ALPHA) && arb_is_positive(box + BETA) && arb_is_positive(box + BETA_S) &&
              arb_is_positive(box + ETA) && arb_is_positive(box + H) && arb_is_positive(box + SB);
    from(x, 1, box + H);
    is = is && arb_is_positive(x);
    from(x, 2, box + ETA);
    is = is && arb_is_positive(x);
    from(x, 1, box + CA);
    is = is && arb_is_positive(x);
    arb_const_pi(x, bits);
    sub(x, x, box + ALPHA);
    is = is && arb_is_positive(x);
    sub(x, box + ALPHA, box + BETA);
    is = is && arb_is_positive(x);
    sub(x, box + ALPHA, box + BETA_S);
    is = is && arb_is_positive(x);
    mul(x, box + H, box + SA);
    less_by(x, box + ALPHA, box + CA);
    is = is && arb_is_positive(x);
    mul(x, box + H, box + CA);
    more_by(x, box + ALPHA, box + SA);
    is = is && arb_is_positive(x);
    arb_sin_cos(s, c, box + BETA_S, bits);
    mul(x, box + BETA_S, c);
    from(c, 1, box + H);
    more_by(x, c, s);
    is = is && arb_is_positive(x);
    from(s, 2, box + ETA);
    plus(x, box + ETA, 2);
    less_by(x, s, box + CB);
    return is && arb_is_positive(x);
}

/* -Y F(m) + (I - Y F'(X)) (X - m) in the place of `step`; whether m and it lie in the interior of X. */
static bool is_contracted(slong radius) {
    arb_ptr about = room + 15, sum = room + 16, entry = room + 17;
    bool is = true;
    arb_zero(about);
    arb_add_error_2exp_si(about, radius);
    for (int i = 0; i < 3; i++) {
        arb_zero(sum);
        for (int k = 0; k < 3; k++) {
            mul(entry, preconditioner + 3 * i, jacobian + k);
            more_by(entry, preconditioner + 3 * i + 1, jacobian + 3 + k);
            more_by(entry, preconditioner + 3 * i + 2, jacobian + 6 + k);
            if (i == k) less(entry, entry, 1);
            more_by(sum, entry, about);
        }
        sub(step + i, step + i, sum);
        is = is && arb_contains_interior(about, step + i);
    }
    return is;
}

/* The proof, as arb.py has it: the last step encloses. */
static bool proof(arb_ptr out, slong goal) {
    slong half = goal / 2 + LOST;
    newton(half, NULL);
    bits = goal;
    evaluate(centre);
    reduced(residuals, centre);
    friction(out + 5, room, centre);
    for (int widening = 0; widening < 8; widening++) {
        slong radius = 16 * widening - half + 8;
        bits = half;
        rounded(box, centre);
        /* Sine and cosine move no further than their argument. */
        for (int i = ALPHA; i <= SG; i++) arb_add_error_2exp_si(box + i, radius + (i >= CG));
        eliminated(box);
        slopes(jacobian, gradients, box);
        for (int i = 0; i < 9; i++) arb_get_mid_arb(middle + i, jacobian + i);
        inverse(preconditioner, middle);
        for (int i = 0; i < 9; i++) arb_get_mid_arb(preconditioner + i, preconditioner + i);
        product(step, preconditioner, residuals);
        if (!is_contracted(radius)) continue;
        product(others, gradients, step);
        if (!is_admissible()) continue;
        bits = goal;
        for (int i = 0; i < 3; i++) sub(out + i, centre + i, step + i);
        sub(out + 3, centre + ETA, others);
        sub(out + 4, centre + H, others + 1);
        sub(out + 5, out + 5, others + 2);
        return true;
    }
    return false;
}

/* What follows from the unknowns: phi, eta h, alpha cot(alpha/2), and four angles in degrees. */
static bool quantities(arb_ptr out, slong goal) {
    arb_ptr degrees = room;
    if (!proof(out, goal)) return false;
    arb_atan(out + 6, out + 5, bits);
    mul(out + 7, out + 3, out + 4);
    arb_mul_2exp_si(out + 8, out, -1);
    arb_cot(out + 8, out + 8, bits);
    mul(out + 8, out + 8, out);
    arb_const_pi(degrees, bits);
    arb_ui_div(degrees, 180, degrees, bits);
    mul(out + 9, out + 6, degrees);
    for (int i = 0; i < 3; i++) mul(out + 10 + i, out + i, degrees);
    return true;
}

/* The yardstick: sines and cosines of the three angles. */
static bool bare(arb_ptr out, slong goal) {
    for (int i = 0; i < 3; i++) arb_sin_cos(room, room + 1, out + i, goal);
    return true;
}

typedef bool (*job)(arb_ptr, slong);

/* Seconds of some calls; a job that proves nothing ends the program. */
static double spent(job job, slong goal, arb_ptr out, int decimals, slong digits, long calls) {
    struct timespec begin, end;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &begin);
    for (long call = 0; call < calls; call++) {
        if (!job(out, goal)) exit(1);
        for (int i = 0; i < decimals; i++) flint_free(arb_get_str(out + i, digits, NO_RADIUS));
    }
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &end);
    return (double)(end.tv_sec - begin.tv_sec) + 1e-9 * (double)(end.tv_nsec - begin.tv_nsec);
}

static int by_size(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

int main(int count, char **arguments) {
    if (count != 3) return 2;
    const char *method = arguments[1];
    slong digits = atol(arguments[2]), length = digits * 3322 / 1000 + 1, goal = length + PROOF_GUARD;
    arb_struct out[QUANTITIES];
    for (int i = 0; i < QUANTITIES; i++) arb_init(out + i);
    flint_set_num_threads(1);
    start();
    int decimals = 0;
    job job = quantities;
    if (!strcmp(method, "newton")) {
        job = newton_of_all;
        goal = length + GUARD;
    } else if (!strcmp(method, "proof")) {
        job = proof;
    } else if (!strcmp(method, "bare")) {
        newton_of_all(out, goal);
        job = bare;
    } else if (!strcmp(method, "quantities")) {
        decimals = QUANTITIES;
    } else if (strcmp(method, "enclosures")) {
        return 2;
    }
    spent(job, goal, out, decimals, digits, 1);
    long calls = 1;
    while (spent(job, goal, out, decimals, digits, calls) < SAMPLE) calls *= 2;
    double samples[SAMPLES], sum = 0;
    int taken = 0;
    while (taken < SAMPLES && sum < BUDGET) {
        samples[taken] = spent(job, goal, out, decimals, digits, calls);
        sum += samples[taken++];
    }
    qsort(samples, (size_t)taken, sizeof *samples, by_size);
    printf("{\"seconds\": %.9g, \"warm\": true, \"values\": [", samples[taken / 2] / (double)calls);
    for (int i = 0; i < UNKNOWNS; i++) {
        char *text = arb_get_str(out + i, digits, NO_RADIUS);
        printf("%s\"%s\"", i ? ", " : "", text);
        flint_free(text);
    }
    puts("]}");
    return 0;
}
