//! What is asked of an arch, and the certificate that answers it.

use crate::answer::Answer;
use crate::failure::{Failure, wrong};
use couplet::Error;
use couplet::ask::{ArchQuestion, Field};
use std::io;

/// Question about an arch with a joint at every angle.
pub(crate) const ARCH: ArchQuestion = ArchQuestion {
    refuses: &[
        (Field::Stones, JOINTS),
        (Field::Joints, JOINTS),
        (Field::Tilt, "the command `couplet assess` tells of an arch that is tilted"),
    ],
    needs: &[],
    unlimited: false,
    example: "",
};
const JOINTS: &str = "the command `couplet voussoirs` tells of an arch of stones";

/// The answer that holds a certificate, which is written as its file has it.
pub(crate) fn certified<T>(
    made: Result<T, Error>,
    write: fn(&T, &mut dyn io::Write) -> io::Result<()>,
) -> Result<Answer, Failure> {
    match made {
        Ok(certificate) => Answer::certificate(|out| write(&certificate, out)),
        Err(Error::Undecided(open)) => Ok(Answer::undecided(open.to_string())),
        Err(Error::Refused(refused)) => Err(wrong(refused)),
    }
}
