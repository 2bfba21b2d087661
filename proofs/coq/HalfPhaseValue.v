(** The half phase of the paper's figure, a = 12.65, b = 0.0629, at u = 1/4, by Coq's own quadrature. *)
Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Polhode Require Import HalfPhase.
Open Scope R_scope.

Theorem half_phase_value :
  Rabs (G (1265/100) (629/10000) (1/4) - 4657934819236146/10^15) <= 1/10^12.
Proof.
unfold G, h, X, Q. integral with (i_degree 12, i_fuel 500, i_prec 60).
Qed.
