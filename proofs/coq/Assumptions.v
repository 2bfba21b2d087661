(** What the theorems rest on: the axioms of the standard reals. *)
Set Printing Width 1000000.
From Polhode Require GaussIntegral ThirdKind ThirdKindBounds AgmLimit Beta Physical HalfPhase BetaDigits.
Print Assumptions GaussIntegral.gauss_invariance.
Print Assumptions ThirdKind.third_kind_step.
Print Assumptions ThirdKindBounds.is_above_sound.
Print Assumptions ThirdKindBounds.is_below_sound.
Print Assumptions ThirdKindBounds.third_kind_of_product.
Print Assumptions AgmLimit.agm_limit.
Print Assumptions Beta.beta_exists_unique.
Print Assumptions Beta.beta_agm.
Print Assumptions Physical.physical_iff.
Print Assumptions HalfPhase.f_derive.
Print Assumptions HalfPhase.f_derive_negative.
Print Assumptions HalfPhase.G_derive.
Print Assumptions HalfPhase.G_derive_negative.
Print Assumptions HalfPhase.G_decreasing.
Print Assumptions BetaDigits.beta_digits.
Print Assumptions BetaDigits.beta_width.
