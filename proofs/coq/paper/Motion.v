(** Equation (6) of the paper from Euler's equations J' = J x I^-1 J, and equation (7) with c constant. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.
Section Motion.
Variables Ix Iy Iz : R.
Hypothesis H : 0 < Iz < Iy /\ Iy < Ix.
Variables th ps : R -> R.
Variables dth dps : R -> R.
Hypothesis Dth : forall t, is_derive th t (dth t).
Hypothesis Dps : forall t, is_derive ps t (dps t).
Definition Jx t := - sin (th t) * cos (ps t).
Definition Jy t := sin (th t) * sin (ps t).
Definition Jz t := cos (th t).
(** Euler's equations, J' = J x (I^-1 J). *)
Hypothesis Ex : forall t, is_derive Jx t (Jy t * (Jz t / Iz) - Jz t * (Jy t / Iy)).
Hypothesis Ey : forall t, is_derive Jy t (Jz t * (Jx t / Ix) - Jx t * (Jz t / Iz)).
Hypothesis Ez : forall t, is_derive Jz t (Jx t * (Jy t / Iy) - Jy t * (Jx t / Ix)).
Hypothesis regular : forall t, 0 < sin (th t).

Theorem theta_equation t : dth t = (1/Iy - 1/Ix) * sin (th t) * sin (ps t) * cos (ps t).
Proof.
assert (D : is_derive Jz t (- dth t * sin (th t))).
{ unfold Jz. evar_last. apply (is_derive_comp cos th). apply is_derive_Reals, derivable_pt_lim_cos. apply Dth.
  unfold scal; simpl; unfold mult; simpl. ring. }
assert (E := is_derive_unique _ _ _ D). rewrite (is_derive_unique _ _ _ (Ez t)) in E. unfold Jx, Jy in E.
assert (S := regular t). apply (Rmult_eq_reg_r (sin (th t))); [|lra].
apply Ropp_eq_compat in E. replace (- (- dth t * sin (th t))) with (dth t * sin (th t)) in E by ring. rewrite <- E. field. lra.
Qed.

Theorem psi_equation t : dps t = (1/Iz - 1/Iy * sin (ps t)^2 - 1/Ix * cos (ps t)^2) * cos (th t).
Proof.
assert (S := regular t).
assert (Dx : is_derive Jx t (- (dth t * cos (th t) * cos (ps t)) + sin (th t) * (sin (ps t) * dps t))).
{ unfold Jx. auto_derive. repeat split; eexists; [apply Dth|apply Dps].
  change (fun x => th x) with th; change (fun x => ps x) with ps. rewrite (is_derive_unique th _ _ (Dth t)), (is_derive_unique ps _ _ (Dps t)). ring. }
assert (Dy : is_derive Jy t (dth t * cos (th t) * sin (ps t) + sin (th t) * (cos (ps t) * dps t))).
{ unfold Jy. auto_derive. repeat split; eexists; [apply Dth|apply Dps].
  change (fun x => th x) with th; change (fun x => ps x) with ps. rewrite (is_derive_unique th _ _ (Dth t)), (is_derive_unique ps _ _ (Dps t)). ring. }
assert (EX := is_derive_unique _ _ _ Dx). rewrite (is_derive_unique _ _ _ (Ex t)) in EX.
assert (EY := is_derive_unique _ _ _ Dy). rewrite (is_derive_unique _ _ _ (Ey t)) in EY.
assert (P := sin2_cos2 (ps t)). unfold Rsqr in P. unfold Jx, Jy, Jz in *.
set (s := sin (ps t)) in *. set (k := cos (ps t)) in *. set (st := sin (th t)) in *. set (ct := cos (th t)) in *.
apply (Rmult_eq_reg_l st); [|lra].
assert (C : st * dps t = s * (- (dth t * ct * k) + st * (s * dps t)) + k * (dth t * ct * s + st * (k * dps t))).
{ replace (st * dps t) with ((s*s + k*k) * (st * dps t)) at 1 by (rewrite P; ring). ring. }
rewrite C, <- EX, <- EY. simpl.
replace (1/Iz) with ((s*s + k*k) * (1/Iz)) by (rewrite P; ring). field. lra.
Qed.

(** c = 2 Iy H - 1; FreeBody.v names a = Iy/Iz - 1 and b = 1 - Iy/Ix. *)
Definition c t := 2 * Iy * (Jx t^2/(2*Ix) + Jy t^2/(2*Iy) + Jz t^2/(2*Iz)) - 1.
Theorem c_in_angles t : c t = (Iy/Iz - 1) - sin (th t)^2 * ((Iy/Iz - 1) + (1 - Iy/Ix) * cos (ps t)^2).
Proof.
unfold c, Jx, Jy, Jz. assert (P := sin2_cos2 (ps t)). assert (Q := sin2_cos2 (th t)). unfold Rsqr in *.
set (s := sin (ps t)) in *. set (k := cos (ps t)) in *. set (st := sin (th t)) in *. set (ct := cos (th t)) in *.
assert (P' : s*s = 1 - k*k) by lra. assert (Q' : ct*ct = 1 - st*st) by lra.
field_simplify_eq; [|lra]. simpl. ring [P' Q'].
Qed.
Theorem c_constant t : is_derive c t 0.
Proof.
assert (A := Ex t). assert (B := Ey t). assert (C := Ez t).
unfold c. auto_derive. repeat split; eexists; [apply A|apply B|apply C].
change (fun x => Jx x) with Jx. change (fun x => Jy x) with Jy. change (fun x => Jz x) with Jz.
rewrite (is_derive_unique Jx _ _ A), (is_derive_unique Jy _ _ B), (is_derive_unique Jz _ _ C). field. lra.
Qed.
End Motion.
