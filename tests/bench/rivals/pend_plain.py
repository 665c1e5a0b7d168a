# SPDX-License-Identifier: GPL-3.0-or-later
# own prototype: pendulum normal form, exact, differential Laurent ring in (xi, r, G=sqrt g, sigma), sigma^4=xi^2+r^2
from fractions import Fraction as Fr
import sys
# coef: dict {(xi,r,G,sig): (re,im)}
def cadd(a,b,m=1):
    r=dict(a)
    for k,(x,y) in b.items():
        p=r.get(k,(Fr(0),Fr(0))); q=(p[0]+m*x,p[1]+m*y)
        if q==(0,0): r.pop(k,None)
        else: r[k]=q
    return r
def reduce(c):
    # xi^2 -> sig^4 - r^2
    out={}
    work=list(c.items())
    while work:
        (k,v)=work.pop()
        if k[0]>=2:
            work.append(((k[0]-2,k[1],k[2],k[3]+4),v)); work.append(((k[0]-2,k[1]+2,k[2],k[3]),(-v[0],-v[1])))
        else:
            p=out.get(k,(Fr(0),Fr(0))); q=(p[0]+v[0],p[1]+v[1])
            if q==(0,0): out.pop(k,None)
            else: out[k]=q
    return out
def cmul(a,b):
    r={}
    for k,(x,y) in a.items():
        for l,(u,v) in b.items():
            m=(k[0]+l[0],k[1]+l[1],k[2]+l[2],k[3]+l[3])
            p=r.get(m,(Fr(0),Fr(0))); r[m]=(p[0]+x*u-y*v,p[1]+x*v+y*u)
    return reduce({k:v for k,v in r.items() if v!=(0,0)})
def cdiff(a): # d/dxi ; dsig/dxi = xi/(2 sig^3)
    r={}
    for k,(x,y) in a.items():
        if k[0]: r=cadd(r,{(k[0]-1,)+k[1:]:(x*k[0],y*k[0])})
        if k[3]: r=cadd(r,{(k[0]+1,k[1],k[2],k[3]-4):(x*Fr(k[3],2),y*Fr(k[3],2))})
    return reduce(r)
def cconj(a): return {k:(x,-y) for k,(x,y) in a.items()}
def C(re=0,im=0,xi=0,r=0,G=0,sig=0): return {(xi,r,G,sig):(Fr(re),Fr(im))}
ONE=C(1)
# series: dict {(a,b,c): coef} monomial w^a wb^b e^c
def padd(p,q,m=1):
    r=dict(p)
    for k,c in q.items():
        t=cadd(r.get(k,{}),c,m)
        if t: r[k]=t
        else: r.pop(k,None)
    return r
def pmul(p,q,K):
    r={}
    for k,c in p.items():
        for l,d in q.items():
            m=(k[0]+l[0],k[1]+l[1],k[2]+l[2])
            if sum(m)>K: continue
            r[m]=cadd(r.get(m,{}),cmul(c,d))
    return {k:v for k,v in r.items() if v}
def pscale(p,c): return {k:cmul(v,c) for k,v in p.items()}
def conj(p): return {(b,a,c):cconj(v) for (a,b,c),v in p.items()}
def dw(p): return {(a-1,b,c):cmul(v,C(a)) for (a,b,c),v in p.items() if a}
def dwb(p): return {(a,b-1,c):cmul(v,C(b)) for (a,b,c),v in p.items() if b}
def dxi(p): return {k:w for k,w in ((k,cdiff(v)) for k,v in p.items()) if w}
def part(p,k): return {m:c for m,c in p.items() if sum(m)==k}
def psin(x,K):
    s={};term=x;n=1;x2=pmul(x,x,K);sg=1;f=Fr(1)
    while term and n<=K:
        s=padd(s,pscale(term,C(f))); term=pmul(term,x2,K); f=-f/((n+1)*(n+2)); n+=2
    return s
def pcos(x,K):
    s={(0,0,0):ONE};x2=pmul(x,x,K);term=x2;n=2;f=Fr(-1,2)
    while term and n<=K:
        s=padd(s,pscale(term,C(f))); term=pmul(term,x2,K); f=-f/((n+1)*(n+2)); n+=2
    return s
om=C(1,0,G=1,sig=-1); iom=C(0,1,G=1,sig=-1)
def F(z,K,nonlin=True,forced=True):
    zb=conj(z)
    psi=pscale(padd(z,zb),C(Fr(1,2)))
    r=pscale(padd(z,zb,-1),C(Fr(-1,4),0,xi=1,sig=-4))
    r=pmul(r,{(0,0,1):ONE},K)
    if nonlin: r=padd(r,pscale(padd(psin(psi,K),psi,-1),iom))
    if forced: r=padd(r,{(0,0,2):C(0,-1,xi=1,r=1,G=-1,sig=1-8)})
    return padd(r,pscale(z,iom))
def normalise(K,**kw):
    h={};N={}
    W={(1,0,0):ONE};E={(0,0,1):ONE}
    for k in range(2,K+1):
        z=padd(W,h)
        rhs=part(padd(F(z,k,**kw),pscale(z,iom),-1),k)
        # total derivative lower: h_w N + h_wb Nb + h_xi e
        t=pmul(dw(h),N,k); t=padd(t,pmul(dwb(h),conj(N),k)); t=padd(t,pmul(dxi(h),E,k))
        rhs=padd(rhs,part(t,k),-1)
        # L: iom (a-b-1) h + N = rhs
        for (a,b,c),v in rhs.items():
            d=a-b-1
            if d==0: N[(a,b,c)]=v
            else: h[(a,b,c)]=cmul(v,C(0,Fr(-1,d),G=-1,sig=1))
    return h,N
def drift(h,N,K,which):
    W={(1,0,0):ONE};E={(0,0,1):ONE}
    z=padd(W,h);psi=pscale(padd(z,conj(z)),C(Fr(1,2)))
    psi={k:v for k,v in psi.items() if v}
    s,c=psin(psi,K),pcos(psi,K)
    i2=C(1,sig=-2)
    if which=='x': f=padd(pscale(c,cmul(C(1,r=1),i2)),pscale(s,cmul(C(1,xi=1),i2)),-1)
    else: f=padd(pscale(s,cmul(C(1,r=1),i2)),pscale(c,cmul(C(1,xi=1),i2)))
    f=pmul(f,E,K)
    hx={};Nx={}
    for k in range(1,K+1):
        rhs=part(f,k)
        t=pmul(dw(hx),N,k);t=padd(t,pmul(dwb(hx),conj(N),k));t=padd(t,pmul(dxi(hx),E,k))
        rhs=padd(rhs,part(t,k),-1)
        for (a,b,c_),v in rhs.items():
            if a==b: Nx[(a,b,c_)]=v
            else: hx[(a,b,c_)]=cmul(v,C(0,Fr(-1,a-b),G=-1,sig=1))
    return hx,Nx
def show(c):
    return ' + '.join(f"({x}{'+' if y>=0 else ''}{y}i) xi^{k[0]} r^{k[1]} G^{k[2]} sig^{k[3]}" for k,(x,y) in sorted(c.items()))
def ev(c,xi,r,g):
    G=g**0.5; sg=(xi*xi+r*r)**0.25
    return sum(complex(float(x),float(y))*xi**k[0]*r**k[1]*G**k[2]*sg**k[3] for k,(x,y) in c.items())
if __name__=='__main__':
    import time
    K=int(sys.argv[1]); t=time.time()
    h,N=normalise(K)
    print('time',time.time()-t)
    for k in sorted(N,key=lambda m:(sum(m),m)): print('z1:',k,show(N[k]))
    for q in 'xy':
        hx,Nx=drift(h,N,K,q)
        for k in sorted(Nx,key=lambda m:(sum(m),m)): print(q,k,show(Nx[k]))
    print('time',time.time()-t)
