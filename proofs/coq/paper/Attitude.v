(** The attitude R = Rz(phi) Ry(theta) Rz(psi): the derivatives of its entries give R' = R [omega]x in the
    paper's angles (section 2). *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.
(** R = Rz(phi) Ry(theta) Rz(psi) has the third row (-sin theta cos psi, sin theta sin psi, cos theta) = J in the body frame, J along Z.
    R' = R [omega]x, omega = I^-1 J; only the third column of it is needed. *)
Section Attitude.
Variables Ix Iy Iz : R.
Hypothesis HI : 0 < Iz /\ 0 < Iy /\ 0 < Ix.
Variables th ps ph dth dph : R -> R.
Hypothesis Dth : forall t, is_derive th t (dth t).
Hypothesis Dph : forall t, is_derive ph t (dph t).
Hypothesis regular : forall t, 0 < sin (th t).
Definition R11 t := cos (ph t) * cos (th t) * cos (ps t) - sin (ph t) * sin (ps t).
Definition R12 t := - (cos (ph t) * cos (th t) * sin (ps t)) - sin (ph t) * cos (ps t).
Definition R21 t := sin (ph t) * cos (th t) * cos (ps t) + cos (ph t) * sin (ps t).
Definition R22 t := - (sin (ph t) * cos (th t) * sin (ps t)) + cos (ph t) * cos (ps t).
Definition R13 t := cos (ph t) * sin (th t).
Definition R23 t := sin (ph t) * sin (th t).
Definition wx t := (- sin (th t) * cos (ps t)) / Ix.
Definition wy t := (sin (th t) * sin (ps t)) / Iy.
Hypothesis K13 : forall t, is_derive R13 t (wy t * R11 t - wx t * R12 t).
Hypothesis K23 : forall t, is_derive R23 t (wy t * R21 t - wx t * R22 t).
Theorem phi_equation t : dph t = 1/Iy * sin (ps t)^2 + 1/Ix * cos (ps t)^2.
Proof.
assert (S := regular t).
assert (D1 : is_derive R13 t (- (sin (ph t) * dph t) * sin (th t) + cos (ph t) * (cos (th t) * dth t))).
{ unfold R13. auto_derive. repeat split; eexists; [apply Dph|apply Dth].
  change (fun x => th x) with th; change (fun x => ph x) with ph. rewrite (is_derive_unique th _ _ (Dth t)), (is_derive_unique ph _ _ (Dph t)). ring. }
assert (D2 : is_derive R23 t (cos (ph t) * dph t * sin (th t) + sin (ph t) * (cos (th t) * dth t))).
{ unfold R23. auto_derive. repeat split; eexists; [apply Dph|apply Dth].
  change (fun x => th x) with th; change (fun x => ph x) with ph. rewrite (is_derive_unique th _ _ (Dth t)), (is_derive_unique ph _ _ (Dph t)). ring. }
assert (E1 := is_derive_unique _ _ _ D1). rewrite (is_derive_unique _ _ _ (K13 t)) in E1.
assert (E2 := is_derive_unique _ _ _ D2). rewrite (is_derive_unique _ _ _ (K23 t)) in E2.
assert (P := sin2_cos2 (ph t)). unfold Rsqr in P. unfold R11, R12, R21, R22, wx, wy in *.
set (s := sin (ps t)) in *. set (k := cos (ps t)) in *. set (st := sin (th t)) in *. set (ct := cos (th t)) in *.
set (sp := sin (ph t)) in *. set (cp := cos (ph t)) in *.
apply (Rmult_eq_reg_l st); [|lra].
assert (C : st * dph t = cp * (cp * dph t * st + sp * (ct * dth t)) - sp * (- (sp * dph t) * st + cp * (ct * dth t))).
{ replace (st * dph t) with ((sp*sp + cp*cp) * (st * dph t)) at 1 by (rewrite P; ring). ring. }
rewrite C, <- E1, <- E2. assert (P' : sp*sp = 1 - cp*cp) by lra. field_simplify_eq; [|lra]. simpl. ring [P'].
Qed.
End Attitude.
