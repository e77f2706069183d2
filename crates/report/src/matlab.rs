//! MATLAB and Octave: a function that returns a structure.

use super::answers::Answers;
use super::listing::{comments, listing};
use super::names::{Named, bits, preface};
use std::io;

const NOTES: &str = "%
%   c = couplet_constants()  has the double  c.T.heyman.thickness.value  and beside it lower, upper,
%   error, text (all digits), and digits: the same for the Symbolic Math Toolbox (in Octave, the loaded
%   package symbolic), or [] without it. Name the file couplet_constants.m.
";

const SYMBOLIC: &str = "
function x = digits_of(text, digits)
% The number with all its digits, where there is symbolic arithmetic.
  x = [];
  if any(exist('vpa') == [2 3 5 6 103])
    try
      x = vpa(text, digits);
    catch
      x = [];
    end
  end
end
";

pub(super) fn answers(report: &Answers, out: &mut dyn io::Write) -> io::Result<()> {
    writeln!(out, "function c = couplet_constants()")?;
    comments(preface(report), "%   ", out)?;
    write!(out, "{NOTES}")?;
    writeln!(out, "  c = struct();")?;
    listing(report, "  % ", out, |named, out| value(named, report.digits, out))?;
    writeln!(out, "end")?;
    write!(out, "{SYMBOLIC}")
}

fn value(named: &Named, digits: usize, out: &mut dyn io::Write) -> io::Result<()> {
    let name = format!("c.{}", named.words.join("."));
    writeln!(out, "  % {}", named.remark())?;
    for (suffix, x) in named.doubles() {
        let field = suffix.strip_prefix('_').unwrap_or("value").to_lowercase();
        writeln!(out, "  {name}.{field} = hex2num('{}');", bits(x))?;
    }
    writeln!(out, "  {name}.text = '{}';", named.value.text())?;
    // `vpa` wants two digits at least.
    writeln!(out, "  {name}.digits = digits_of({name}.text, {});", digits.max(2))
}
