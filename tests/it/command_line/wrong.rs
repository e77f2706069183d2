//! Wrong input is told in one line, with what is possible.

wrong_uses! {
    an_unknown_landmark: ["constants", "X"] => "one of T, S, J, B, l, L, sb";
    a_landmark_in_small_letters: ["constants", "t"] => "(did you mean \"T\"?)";
    half_a_landmark: ["state", "--at", "tripel"] => "(did you mean \"triple\"?)";
    a_misspelt_weight: ["constants", "--weight", "heymann"] => "(did you mean \"heyman\"?)";
    both_weights_of_a_certificate:
        ["certify", "T", "--weight", "both"] => "one of heyman, milankovitch";
    an_unknown_format: ["constants", "--format", "yaml"] => "one of table, plain, json, csv";
    a_misspelt_format: ["constants", "--format", "jsn"] => "(did you mean \"json\"?)";
    no_format: ["audit", "--format", ""] => "one of table, json, csv";
    an_unknown_quantity: ["constants", "--quantity", "thicknes"] => "(did you mean \"thickness\"?)";
    a_quantity_of_something_else: ["constants", "--quantity", "sliding_friction"]
        => "there is no sliding_friction here; the quantities are thickness";
    a_quantity_that_no_landmark_asked_for_has:
        ["constants", "sb", "--quantity", "mu"] => "none of these landmarks";
    two_formats: ["constants", "--plain", "--format", "json"] => "cannot be used with";
    no_threads: ["constants", "--threads", "0"] => "from 1 to 1024";
    a_colour: ["constants", "--color", "red"] => "auto, always, never";
    no_digits: ["constants", "--digits", "0"] => "from 1 to 1000000";
    negative_digits: ["constants", "--digits", "-5"] => "from 1 to 1000000";
    digits_in_words: ["constants", "--digits", "ten"] => "from 1 to 1000000";
    a_digit_too_many: ["constants", "--digits", "1000001"] => "from 1 to 1000000";
    digits_beyond_64_bits: ["constants", "--digits", "99999999999999999999999"] => "from 1 to 1000000";
    half_a_digit: ["constants", "--digits", "30.5"] => "from 1 to 1000000";
    an_option_without_its_value: ["constants", "--digits"] => "a value is required";
    an_option_that_is_none: ["constants", "--digit", "3"] => "--digits";
    a_command_that_is_none: ["constant"] => "constants";
    an_unknown_claim: ["prove", "eq-7-eat"] => "(did you mean \"eq-7-eta\"?); --list shows the claims";
    half_a_claim: ["prove", "eq-"] => "unknown claim 'eq-'";
    a_format_that_claims_do_not_have: ["prove", "--format", "toml"] => "one of text, json, csv, csv2, latex, markdown";
    an_unknown_experiment: ["study", "accuracy", "--only", "T"] => "the studies are eta-cubic, A-cubic";
    an_unknown_limit: ["study", "stability", "--only", "state"] => "the studies are alpha-to-zero";

    an_equation_that_is_none: ["equation", "19", "--beta", "1"] => "a number from 2 to 18";
    an_equation_of_no_joint: ["equation", "6", "--beta", "1"] => "equation (6) takes only --thickness";
    a_thickness_without_an_intrados: ["equation", "5", "--beta", "1", "--eta", "2"] => "(5) has no value there";
    overturning_of_the_other_weight: ["equation", "14", "--opening-variable", "0.6"] => "(14) is not for";
    an_equation_without_its_joint: ["equation", "7"] => "equation (7) needs --rotation-joint";
    a_joint_beyond_half_a_turn: ["equation", "7", "--beta", "4"] => "did you mean 4deg?";
    a_negative_joint: ["equation", "12", "--beta", "-1"] => "between 0 and pi";
    a_closed_form_of_heyman:
        ["equation", "9", "--beta", "1", "--weight", "both"] => "for Milankovitch's weight";
    a_closed_form_beyond_the_widest_joint: ["equation", "11", "--beta", "1.2"] => "beyond the widest";

    a_joint_beside_a_half_opening: ["state", "--alpha", "1", "--beta", "1"] => "give one of --half-opening";
    two_quantities_of_a_state: ["state", "--thrust", "0.5", "--beta", "1"] => "give one of --half-opening";
    a_thickness_beside_a_joint: ["state", "--eta", "0.1", "--beta", "1"] => "give one of --half-opening";
    a_span_of_an_opening_variable: ["state", "--opening-variable", "1", "--span", "10m", "--rise", "3m"] =>
        "--span does not go with --opening-variable";
    stones_of_a_joint: ["state", "--stones", "9", "--beta", "1"] => "--stones does not go with --rotation-joint";
    a_thrust_of_one: ["state", "--thrust", "1"] => "thrust = 1 is not between 0 and 1";
    an_opening_variable_of_two: ["state", "--opening-variable", "2"] => "A = 2 is not between 0 and 2";
    a_state_of_a_joint_in_degrees: ["state", "--beta", "57"] => "did you mean 57deg?";
    a_joint_in_a_format_it_does_not_have: ["state", "--beta", "1", "--format", "c"] => "written only as";

    plain_of_a_record: ["voussoirs", "--plain"] => "there is no --plain: this answer is told whole";
    a_load: ["assess", "--load", "10kN"] => "there is no --load: the load is the weight of the arch itself";
    a_pointed_arch: ["draw", "--pointed"] => "arches are circular, of one thickness (docs/limits.md)";
    a_length_with_a_comma: ["state", "--span", "1.250,5cm", "--rise", "3m", "--mu", "1"] => "has ',' between its digits";

    a_zero_half_opening: ["state", "--alpha", "0", "--mu", "1"] => "between 0 and pi";
    a_negative_half_opening: ["state", "--alpha", "-1", "--mu", "1"] => "between 0 and pi";
    a_half_opening_beyond_a_turn: ["state", "--alpha", "3.2", "--mu", "1"] => "between 0 and pi";
    half_a_turn_in_degrees: ["state", "--alpha", "180deg", "--mu", "1"] => "between 0 and pi";
    nan: ["state", "--alpha", "nan", "--mu", "1"] => "'nan'";
    a_tiny_half_opening: ["state", "--alpha", "1e-1000000000", "--mu", "1"] => "out of range";
    a_negative_friction: ["state", "--alpha", "1", "--mu", "-1"] => "negative";
    a_huge_friction: ["state", "--alpha", "1", "--mu", "1e1000000000"] => "out of range";
    a_friction_angle_too_large:
        ["state", "--alpha", "1", "--friction-angle", "91deg"] => "between 0 and pi/2";
    a_negative_friction_angle:
        ["state", "--alpha", "1", "--friction-angle", "-1deg"] => "between 0 and pi/2";
    no_friction: ["state", "--alpha", "1"] => "--friction";
    nothing_of_an_arch: ["state"] => "--half-opening, --friction (or --friction-angle) are missing; for \
        example: couplet state --half-opening";
    nothing_of_an_arch_of_given_thickness: ["assess"] => "--half-opening, --friction (or \
        --friction-angle), --thickness are missing; for example: couplet assess";
    degrees_without_their_unit: ["state", "--alpha", "90", "--mu", "1"] => "did you mean 90deg?";
    a_thickness_in_degrees: ["assess", "--alpha", "1", "--mu", "1", "--eta", "5deg"] => "is no ratio";
    what_is_given_cannot_be_found:
        ["find", "half-opening", "--mu", "0.6", "--eta", "0.15", "--quantity", "eta"]
        => "there is no thickness here; the quantities are half_opening";
    a_decimal_comma: ["state", "--alpha", "1,5", "--mu", "1"] => "has a comma";
    pi_behind_the_line: ["state", "--alpha", "3/4pi", "--mu", "1"] => "3pi/4";
    a_thickness_in_an_unknown_unit: ["draw", "--alpha", "1", "--mu", "1", "--eta", "600km"] => "a length in m, cm";
    a_subject_misspelt: ["certify", "asymetric"] => "did you mean \"asymmetric\"?";
    a_curve_of_another_map: ["map", "--curve", "asymmetric_begins"] => "is drawn with --asymmetric";
    a_division_by_zero: ["state", "--alpha", "1", "--mu", "1/0"] => "divides by zero";
    a_friction_in_words: ["state", "--alpha", "1", "--mu", "none"] => "inf";
    a_size_just_out_of_range: ["state", "--alpha", "1", "--mu", "1e1000"] => "below 1e1000";
    a_state_without_digits: ["state", "--alpha", "1", "--mu", "1", "--digits", "0"] => "from 1 to 1000000";
    a_thickness_beyond_the_limit:
        ["assess", "--alpha", "1", "--mu", "1", "--thickness", "2.5"] => "between 0 and 2";
    a_zero_thickness: ["assess", "--alpha", "1", "--mu", "1", "--thickness", "0"] => "between 0 and 2";
    no_thickness: ["assess", "--alpha", "1", "--mu", "1"] => "--thickness";
}
