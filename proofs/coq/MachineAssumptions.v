(** And those that compute in 63-bit machine integers. *)
Set Printing Width 1000000.
From Polhode Require HalfPhaseValue Epsilon0 BetaManyDigits.
Print Assumptions HalfPhaseValue.half_phase_value.
Print Assumptions Epsilon0.epsilon0_min_digits.
Print Assumptions BetaManyDigits.beta_digits.
Print Assumptions BetaManyDigits.beta_width.
