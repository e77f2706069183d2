//! The options of every picture.

use crate::picture::{Font, PaperLength, Print};
use crate::report::Format;
use crate::sweep::failure::Failure;
use clap::Args;

/// Printing of a picture.
#[derive(Args, Clone)]
#[command(next_help_heading = "Options of pictures")]
pub(super) struct PrintArguments {
    /// Width on paper (84mm, 8.4cm, 3.3in, 240pt); letters and strokes keep their size. If none is given, as wide as
    /// the picture needs.
    #[arg(long, value_name = "LENGTH", value_parser = PaperLength::width, allow_hyphen_values = true)]
    width: Option<PaperLength>,

    /// Size of the smallest letters on paper (7pt, 2.5mm); with --width 7pt if not given.
    #[arg(long, value_name = "LENGTH", value_parser = PaperLength::font_size, allow_hyphen_values = true)]
    font_size: Option<PaperLength>,

    /// Family of letters, for png and pdf one of this machine; DejaVu Sans if not given, which couplet has with it.
    #[arg(long, value_name = "NAME")]
    font: Option<Font>,

    /// Without the words below, which svg and pdf have as their description all the same.
    #[arg(long)]
    no_caption: bool,

    /// All words below: what is proved, how it is drawn, and the command.
    #[arg(long, conflicts_with = "no_caption")]
    full_caption: bool,

    /// Without the headings above.
    #[arg(long)]
    no_title: bool,
}

impl PrintArguments {
    /// Printing of a picture.
    pub(super) fn print(&self) -> Print {
        let Self { width, font_size, font, no_caption, full_caption: details, no_title } =
            self.clone();
        Print { width, font_size, font, caption: !no_caption, details, title: !no_title }
    }

    /// Printing of a picture in a format; what is no picture has none of the options.
    pub(super) fn of(&self, format: &Format) -> Result<Print, Failure> {
        let print = self.print();
        match format.is_picture || print == Print::default() {
            true => Ok(print),
            false => Err(format!(
                "--width, --font-size, --font, --no-caption, --full-caption and --no-title are for svg, png and pdf, not {}",
                format.name
            )
            .into()),
        }
    }
}
