(** * The checker as a program

    The functions [Check.check] and [SurveyCheck.check_survey] in OCaml, with Zarith's integers for [Z] and [positive], as Coq's own file
    [ExtrOcamlZBigInt] has it, and four functions done at once that Coq does bit by bit ([Faster] has why they
    are the same).  No real number is computed: what is left of them in the program is never called. *)

From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlZBigInt.
From Flocq Require Import Core.Zaux.
From Interval Require Import Float.Specific_stdz.
From Couplet Require Import Certificate Check SurveyCheck Faster.

Extraction Language OCaml.
Set Warnings "-extraction-opaque-accessed".

Extract Constant ClassicalDedekindReals.sig_forall_dec => "(fun _ -> assert false)".

(** [digits_faster] *)
Extract Constant StdZRadix2.digits_aux => "Faster.digits".
(** [shl_faster] *)
Extract Constant StdZRadix2.mantissa_shl => "Faster.shifted_left".
(** [shr_faster] *)
Extract Constant StdZRadix2.mantissa_shr =>
  "(fun m d pos ->
     Faster.shifted m d (pos = Pos_Eq)
       ~exact:Pos_Eq ~below:Pos_Lo ~half:Pos_Mi ~above:Pos_Up)".
(** [division_faster] *)
Extract Constant Zfast_div_eucl => "Faster.division".

Extraction "verified.ml" check check_survey Certificate.Certificate modes_of.
