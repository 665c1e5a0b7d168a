# SPDX-License-Identifier: GPL-3.0-or-later
import sys,time
from sympy import ring,QQ
K=int(sys.argv[1])
R,w,b,e,i,x,r,s,S,g,H=ring('w,b,e,i,x,r,s,S,g,H',QQ)
def red(p):
    out={}
    st=list(p.items())
    while st:
        m,c=st.pop()
        (A,B,E,I,X,r_,s_,S_,g_,H_)=m
        t=min(s_,S_);s_-=t;S_-=t;t=min(g_,H_);g_-=t;H_-=t
        if I>=2: c=-c;I-=2
        if X>=2:
            st.append(((A,B,E,I,X-2,r_,s_+4,S_,g_,H_),c));st.append(((A,B,E,I,X-2,r_+2,s_,S_,g_,H_),-c));continue
        k=(A,B,E,I,X,r_,s_,S_,g_,H_)
        v=out.get(k,0)+c
        if v: out[k]=v
        else: out.pop(k,None)
    return R.from_dict(out)
def mul(a,c): return red(a*c)
def conj(p): return R.from_dict({(m[1],m[0],m[2])+m[3:]:(-c if m[3] else c) for m,c in p.items()})
def dxi(p): # ds=x/(2 s^3), dS=-x S^5/2
    return red(p.diff(x)+p.diff(s)*x*S**3*QQ(1,2)-p.diff(S)*x*S**5*QQ(1,2))
Z=R.zero
def flt(p,f): return R.from_dict({m:c for m,c in p.items() if f(m)})
def div(p,off): return R.from_dict({m:c/(m[0]-m[1]-off) for m,c in p.items()})
def normalise(K):
    h=[Z]*(K+2);N=[Z]*(K+2);ps=[Z]*(K+2);sn=[Z]*(K+2);cs=[Z]*(K+2)
    hw=[Z]*(K+2);hb=[Z]*(K+2);Nb=[Z]*(K+2)
    ps[1]=(w+b)/2;sn[1]=ps[1];cs[0]=R.one
    for k in range(2,K+1):
        S3=Z
        for j in range(1,k): S3+=ps[j]*cs[k-j]*QQ(j,k)
        S3=red(S3)
        z=w if k==2 else h[k-1]
        rhs=mul(i*g*S,S3)-(z-conj(z))*x*S**4*e/4
        if k==2: rhs-=i*x*r*H*S**7*e**2
        for j in range(1,k-1): rhs-=hw[j]*N[k-j]+hb[j]*Nb[k-j]
        if k>2: rhs-=dxi(h[k-1])*e
        rhs=red(rhs)
        N[k]=flt(rhs,lambda m:m[0]-m[1]==1);Nb[k]=conj(N[k])
        h[k]=div(red(flt(rhs,lambda m:m[0]-m[1]!=1)*(-i*s*H)),1)
        hw[k-1]=h[k].diff(w);hb[k-1]=h[k].diff(b)
        ps[k]=(h[k]+conj(h[k]))/2;sn[k]=S3+ps[k]
        t=Z
        for j in range(1,k): t-=ps[j]*sn[k-j]*QQ(j,k)
        cs[k]=red(t)
    out=[]
    for q in 'xy':
        hx=[Z]*(K+2);Nx=[Z]*(K+2);xw=[Z]*(K+2);xb=[Z]*(K+2)
        for k in range(1,K+1):
            f=(r*cs[k-1]-x*sn[k-1]) if q=='x' else (r*sn[k-1]+x*cs[k-1])
            rhs=f*e*S**2
            for j in range(1,k-1): rhs-=xw[j]*N[k-j]+xb[j]*Nb[k-j]
            if k>1: rhs-=dxi(hx[k-1])*e
            rhs=red(rhs)
            Nx[k]=flt(rhs,lambda m:m[0]==m[1])
            hx[k]=div(red(flt(rhs,lambda m:m[0]!=m[1])*(-i*s*H)),0)
            xw[k-1]=hx[k].diff(w);xb[k-1]=hx[k].diff(b)
        out+=[hx,Nx]
    return [h,N]+out
best=9e9
for rep in range(3 if K<9 else 1):
    t=time.time();o=normalise(K);best=min(best,time.time()-t)
print('sympy ring K',K,'time',best,'terms',[sum(len(p) for p in q) for q in o])
