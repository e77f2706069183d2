(** * Interval arithmetic over plain integers

    [Interval.Tactic] computes with the primitive integers and floats of the kernel, and every use of it puts their
    specification, some sixty axioms, under the theorem. The same tactic over binary floating-point numbers made of
    [Z] is slower by a small factor and assumes nothing beyond the axioms of the real numbers.

    The tactic still falls back to primitive floats for a call without a precision, so every call reads [interval with
    (i_prec n)]. *)

From Interval Require Import Float.Specific_ops Float.Specific_stdz.
From Interval Require Export Tactic.

Module FloatZ := SpecificFloat StdZRadix2.
Module TacticZ := IntervalTactic FloatZ.
(** From here on [interval] is the one of [TacticZ]. *)
Export TacticZ.
