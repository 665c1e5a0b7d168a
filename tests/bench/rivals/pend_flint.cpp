// SPDX-License-Identifier: GPL-3.0-or-later
// FLINT fmpq_mpoly: vars w,b,e,i,x,r,S(=1/sigma),G ; unit gradings make negative powers avoidable:
// coefficients divided by G^(1-c) etc. trick: work with W=sigma-free scaling: xi=x*s^2, r=r*s^2
// (dimensionless x=sin, r=cos, x^2+r^2=1), drop s,G by units. d/dxi carried by: D(x)=r^2, D(r)=-x r,
// D(s^m)=(m/2) x s^m  (times 1/s^2) s-exponent m of the coefficient of w^a b^b e^c fixed by c: z-equations h:
// s^(-3c), G^(-c)
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <flint/flint.h>
#include <flint/fmpq_mpoly.h>
#include <gmp.h>
#include <vector>
using namespace std;
static double now() {
    return chrono::duration<double>(chrono::steady_clock::now().time_since_epoch()).count();
}
fmpq_mpoly_ctx_t cx;
enum { W, B, E, I, X, R, NV };
struct P {
    fmpq_mpoly_t p;
    P() { fmpq_mpoly_init(p, cx); }
    P(const P& o) {
        fmpq_mpoly_init(p, cx);
        fmpq_mpoly_set(p, o.p, cx);
    }
    P& operator=(const P& o) {
        fmpq_mpoly_set(p, o.p, cx);
        return *this;
    }
    ~P() { fmpq_mpoly_clear(p, cx); }
};
P operator+(const P& a, const P& b) {
    P r;
    fmpq_mpoly_add(r.p, a.p, b.p, cx);
    return r;
}
P operator-(const P& a, const P& b) {
    P r;
    fmpq_mpoly_sub(r.p, a.p, b.p, cx);
    return r;
}
P operator*(const P& a, const P& b) {
    P r;
    fmpq_mpoly_mul(r.p, a.p, b.p, cx);
    return r;
}
P sc(const P& a, long n, long d) {
    P r;
    fmpq_t q;
    fmpq_init(q);
    fmpq_set_si(q, n, d);
    fmpq_mpoly_scalar_mul_fmpq(r.p, a.p, q, cx);
    fmpq_clear(q);
    return r;
}
P gen(int v) {
    P r;
    fmpq_mpoly_gen(r.p, v, cx);
    return r;
}
template <class F> P mp(const P& a, F f) {
    P r;
    ulong ex[NV];
    fmpq_t c;
    fmpq_init(c);
    slong n = fmpq_mpoly_length(a.p, cx);
    for (slong j = 0; j < n; j++) {
        fmpq_mpoly_get_term_exp_ui(ex, a.p, j, cx);
        fmpq_mpoly_get_term_coeff_fmpq(c, a.p, j, cx);
        if (f(ex, c)) fmpq_mpoly_push_term_fmpq_ui(r.p, c, ex, cx);
    }
    fmpq_clear(c);
    fmpq_mpoly_sort_terms(r.p, cx);
    fmpq_mpoly_combine_like_terms(r.p, cx);
    return r;
}
P xx, rr, ONE, rel;
P red(const P& a) { // I^2->-1, X^2->1-R^2
    P b = mp(a, [](ulong* e, fmpq_t c) {
        while (e[I] >= 2) {
            e[I] -= 2;
            fmpq_neg(c, c);
        }
        return true;
    });
    for (;;) {
        bool any = false;
        P lo = mp(b, [&](ulong* e, fmpq_t) {
            if (e[X] >= 2) {
                any = true;
                return false;
            }
            return true;
        });
        if (!any) return b;
        P hi = mp(b, [](ulong* e, fmpq_t) {
            if (e[X] < 2) return false;
            e[X] -= 2;
            return true;
        });
        b = lo + hi - hi * rr * rr;
    }
}
P conj(const P& a) {
    return mp(a, [](ulong* e, fmpq_t c) {
        swap(e[W], e[B]);
        if (e[I]) fmpq_neg(c, c);
        return true;
    });
}
P der(const P& a, int v) {
    P r;
    fmpq_mpoly_derivative(r.p, a.p, v, cx);
    return r;
}
// D of coefficient x^.. r^.. s^m with m = m0-3c ; returned in units s^(m-2)
P dxi(const P& a, int m0) {
    P u = der(a, X) * rr * rr - der(a, R) * xx * rr;
    P v = mp(a, [&](ulong* e, fmpq_t c) {
        long m = m0 - 3 * (long)e[E];
        e[X]++;
        fmpq_t q;
        fmpq_init(q);
        fmpq_set_si(q, m, 2);
        fmpq_canonicalise(q);
        fmpq_mul(c, c, q);
        fmpq_clear(q);
        return m != 0;
    });
    return red(u + v);
}
int main(int ac, char** av) {
    fmpq_mpoly_ctx_init(cx, NV, ORD_DEGLEX);
    xx = P(), rr = P();
    {
        P a = gen(X);
        xx = a;
    }
    {
        P a = gen(R);
        rr = a;
    }
    P w = gen(W), b = gen(B), e = gen(E), i = gen(I);
    for (int K : {3, 5, 7, 9, 11, 13, 15, 17, 19, 21}) {
        double best = 1e9, bz = 0;
        slong nh = 0, nN = 0;
        for (int rep = 0; rep < (K < 13 ? 3 : 1); rep++) {
            double t0 = now();
            vector<P> h(K + 2), N(K + 2), Nb(K + 2), ps(K + 2), sn(K + 2), cs(K + 2), hw(K + 2), hb(K + 2);
            fmpq_mpoly_one(cs[0].p, cx);
            ps[1] = sc(w + b, 1, 2);
            sn[1] = ps[1];
            for (int k = 2; k <= K; k++) {
                P S3;
                for (int j = 1; j < k; j++) S3 = S3 + sc(ps[j] * cs[k - j], j, k);
                S3 = red(S3);
                P z = k == 2 ? w : h[k - 1];
                P rhs = i * S3 - sc((z - conj(z)) * xx * e, 1, 4);
                if (k == 2) rhs = rhs - i * xx * rr * e * e;
                for (int j = 1; j <= k - 2; j++) rhs = rhs - hw[j] * N[k - j] - hb[j] * Nb[k - j];
                if (k > 2) rhs = rhs - dxi(h[k - 1], 0) * e;
                rhs = red(rhs);
                N[k] = mp(rhs, [](ulong* e, fmpq_t) { return e[W] == e[B] + 1; });
                Nb[k] = conj(N[k]);
                h[k] = red(i * mp(rhs, [](ulong* e, fmpq_t c) {
                               long d = (long)e[W] - (long)e[B] - 1;
                               if (!d) return false;
                               fmpq_t q;
                               fmpq_init(q);
                               fmpq_set_si(q, d < 0 ? 1 : -1, labs(d));
                               fmpq_mul(c, c, q);
                               fmpq_clear(q);
                               return true;
                           }));
                hw[k - 1] = der(h[k], W);
                hb[k - 1] = der(h[k], B);
                ps[k] = sc(h[k] + conj(h[k]), 1, 2);
                sn[k] = S3 + ps[k];
                P c;
                for (int j = 1; j < k; j++) c = c - sc(ps[j] * sn[k - j], j, k);
                cs[k] = red(c);
            }
            bz = now() - t0;
            best = min(best, bz);
            nh = nN = 0;
            for (int k = 2; k <= K; k++) {
                nh += fmpq_mpoly_length(h[k].p, cx);
                nN += fmpq_mpoly_length(N[k].p, cx);
            }
            if (rep == 0 && K == 3 && ac > 1) {
                const char* nm[] = {"w", "b", "e", "i", "x", "r"};
                fmpq_mpoly_print_pretty(N[3].p, nm, cx);
                puts("");
            }
        }
        printf("flint fmpq_mpoly z only K %d %.6f h %ld N %ld\n", K, best, nh, nN);
        fflush(stdout);
    }
    return 0;
}
