//! Destination of a report: standard output, or a file that appears whole or not at all.

use super::look::{ArchLook, LookArguments};
use super::notes::each_once;
use super::progress;
use crate::certify::Refused;
use crate::cli::line;
use crate::picture::Print;
use crate::problem::Quantity;
use crate::report::words::shortened;
use crate::report::{Answers, Content, Format, Reported, Sketched};
use crate::sweep::failure::Failure;
use crate::sweep::parse;
use crate::sweep::unfinished::Unfinished;
use clap::Args;
use std::fmt::Display;
use std::fs::{self, File};
use std::io::{self, BufWriter, IsTerminal, Write};
use std::path::{Path, PathBuf};

/// How and where answers are written.
#[derive(Args)]
pub(super) struct AnswerOutput {
    #[arg(
        long, value_parser = parse::format(Answers::content()),
        help = parse::usual_format_help(Answers::content(), "table")
    )]
    format: Option<&'static Format>,

    /// Only the values, one a line: short for --format plain.
    #[arg(long, conflicts_with = "format")]
    plain: bool,

    /// Only these quantities (thickness, thrust, …; eta, mu, h too), with commas between several.
    #[arg(
        long = "quantity", alias = "quantities", value_name = "NAME", value_delimiter = ',',
        value_parser = parse::quantity
    )]
    quantities: Vec<Quantity>,

    #[command(flatten)]
    file: OutputFile,
}

/// Where a report is written.
#[derive(Args)]
pub(super) struct OutputFile {
    /// Write to a file instead of standard output, which `-` is too; it appears whole or not at all.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Where a picture is written, and how.
pub(super) type Printed<'a> = (&'a OutputFile, &'static Format, ArchLook);

impl AnswerOutput {
    /// The format asked for.
    pub(super) fn format(&self) -> Result<&'static Format, Failure> {
        let plain = Format::named(Answers::content(), "plain").filter(|_| self.plain);
        self.file.format(plain.or(self.format), Answers::content(), "table")
    }

    /// The quantities asked for, of those that there are; all if none is named.
    pub(super) fn quantities(&self, all: &[Quantity]) -> Result<Vec<Quantity>, Failure> {
        chosen(&self.quantities, all)
    }

    /// The file, the format and the look of a picture, where the end of the file's name tells one: svg, png or dxf.
    pub(super) fn drawing(&self, look: &LookArguments) -> Result<Option<Printed<'_>>, Failure> {
        let end = self.file.path().and_then(Path::extension).unwrap_or_default().to_string_lossy();
        let is_answer = Format::named(Answers::content(), &end).is_some();
        let format = Format::named(Sketched::content(), &end);
        let format = format.filter(|_| !is_answer && !self.plain && self.format.is_none());
        let look = look.of(format.map_or_else(|| self.format(), Ok)?, format.is_some())?;
        let Some(format) = format else { return Ok(None) };
        self.tells_all("a picture")?;
        Ok(Some((&self.file, format.missing().map_or(Ok(format), Err)?, look)))
    }

    /// The file that is written.
    pub(super) fn file(&self) -> &OutputFile {
        &self.file
    }

    /// Refuses a choice of quantities beside what has all of them.
    pub(super) fn tells_all(&self, what: &str) -> Result<(), Failure> {
        match self.quantities.is_empty() {
            true => Ok(()),
            false => {
                Err(format!("{what} tells all of its quantities: leave out --quantity").into())
            }
        }
    }

    /// Opens the destination, before any work is done, and tells the format.
    pub(super) fn open(&self) -> Result<(Output, &'static Format), Failure> {
        let format = self.format()?;
        Ok((self.file.open_for(format)?, format))
    }
}

impl OutputFile {
    /// Opens the destination, before any work is done.
    pub(super) fn open(&self) -> Result<Output, Failure> {
        Output::open(self.output.as_deref())
    }

    /// Opens the output for a format, which may be binary.
    pub(super) fn open_for(&self, format: &Format) -> Result<Output, Failure> {
        if format.is_binary && !self.is_file() && !line::is_heard() && io::stdout().is_terminal() {
            let name = format.name;
            return Err(format!(
                "refusing to write {name} to a terminal; use --output or redirect"
            )
            .into());
        }
        self.open()
    }

    /// The format given; else that of the file's name, else the usual one.
    pub(super) fn format(
        &self,
        given: Option<&'static Format>,
        content: Content,
        usual: &str,
    ) -> Result<&'static Format, Failure> {
        let given = given.map_or_else(|| self.by_name(content), |given| Ok(Some(given)))?;
        let format = given.or_else(|| Format::named(content, usual));
        let format = format.ok_or_else(|| format!("{usual} is no format"))?;
        Ok(format.missing().map_or(Ok(format), Err)?)
    }

    /// The format that the end of the file's name tells, if it has one.
    pub(super) fn by_name(&self, content: Content) -> Result<Option<&'static Format>, Failure> {
        let Some(end) = self.path().and_then(Path::extension) else { return Ok(None) };
        let end = end.to_string_lossy();
        let format = Format::named(content, &end);
        format.map(Some).ok_or_else(|| {
            let ends = Format::extensions(content);
            let end = shortened(&end);
            format!("the end .{end} tells no format: name the file {ends}, or give --format").into()
        })
    }

    /// The file named, if that is not standard output.
    pub(super) fn path(&self) -> Option<&Path> {
        self.output.as_deref().filter(|path| !is_standard(path))
    }

    /// Tells whether the output is not standard output.
    pub(super) fn is_file(&self) -> bool {
        self.path().is_some()
    }

    /// Tells whether the output is a file that is there.
    pub(super) fn is_same_file(&self, other: &Path) -> bool {
        self.output.as_ref().is_some_and(|output| is_same_file(output, other))
    }
}

/// The quantities asked for, of those that there are; all if none is named.
pub(super) fn chosen(asked: &[Quantity], all: &[Quantity]) -> Result<Vec<Quantity>, Failure> {
    asked.iter().try_for_each(|quantity| Refused::quantity(*quantity, all))?;
    let names = |of: &Quantity| of.name().to_owned();
    let asked = each_once(asked.iter().copied(), |of| *of, names);
    Ok(if asked.is_empty() { all.to_vec() } else { asked })
}

/// Refuses a format that cannot hold what is asked for.
pub(super) fn is_written(what: &str, content: Content, format: &Format) -> Result<(), Failure> {
    match content.is_written_as(format) {
        true => Ok(()),
        false => {
            let names = Format::names(content);
            Err(format!("{what} is written only as {names}, not {}", format.name).into())
        }
    }
}

/// Tells whether a path stands for standard output.
pub(super) fn is_standard(path: &Path) -> bool {
    path == Path::new("-")
}

/// Tells whether two paths lead to one file that is there.
pub(super) fn is_same_file(one: &Path, other: &Path) -> bool {
    match (fs::canonicalize(one), fs::canonicalize(other)) {
        (Ok(one), Ok(other)) => one == other,
        _ => false,
    }
}

/// An opened destination.
pub(super) enum Output {
    /// Standard output.
    Standard,
    /// A device or a pipe, which is written to directly: it cannot be renamed over.
    Stream {
        /// File that is written to.
        stream: File,
        /// The name asked for.
        path: PathBuf,
    },
    /// A temporary file beside the one asked for, renamed over it at the end.
    File {
        /// The unfinished file, where it is, and to be written.
        unfinished: (Unfinished, File),
        /// The file asked for; where the name asked for is a link, what it leads to.
        path: PathBuf,
        /// True if the file asked for belongs to somebody else, and so is written into.
        is_foreign: bool,
    },
}

impl Output {
    /// Opens the destination now: a path that cannot be written fails before any work. A link is followed: what it
    /// leads to is written, and it has to lead somewhere.
    pub(super) fn open(path: Option<&Path>) -> Result<Self, Failure> {
        let Some(path) = path.filter(|path| !is_standard(path)) else { return Ok(Self::Standard) };
        let failed = |error: io::Error| cannot_write(path, &error);
        let there = match fs::metadata(path) {
            Ok(there) if there.is_dir() => return Err(failed(io::ErrorKind::IsADirectory.into())),
            Ok(there) if !there.is_file() => {
                let stream = File::options().write(true).open(path).map_err(failed)?;
                return Ok(Self::Stream { stream, path: path.to_owned() });
            }
            Ok(there) => {
                // To rename over a file the folder is asked, not the file: ask the file too.
                File::options().write(true).open(path).map_err(failed)?;
                Some(there)
            }
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(failed(error)),
            Err(_) if path.is_symlink() => {
                return Err(failed(io::Error::other("it is a link that leads nowhere")));
            }
            Err(_) => None,
        };
        let path =
            if there.is_some() { fs::canonicalize(path).map_err(failed)? } else { path.into() };
        let folder = match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let failed = |error: io::Error| cannot_write(&path, &error);
        let unfinished = Unfinished::file(folder, "").map_err(failed)?;
        let is_foreign = match &there {
            Some(there) => !take_over(there, &unfinished.1).map_err(failed)?,
            None => false,
        };
        Ok(Self::File { unfinished, path, is_foreign })
    }

    /// Writes a report; what stays open in it is a failure.
    pub(super) fn report<T: Display>(
        self,
        (report, format): (&dyn Reported, &Format),
        open: impl IntoIterator<Item = T>,
    ) -> Result<(), Failure> {
        self.printed((report, format, &Print::default()), open)
    }

    /// Writes a report, a picture as it is printed and told of where that takes long; what stays open is a failure.
    pub(super) fn printed<T: Display>(
        self,
        (report, format, print): (&dyn Reported, &Format, &Print),
        open: impl IntoIterator<Item = T>,
    ) -> Result<(), Failure> {
        let write = || self.write(|out| report.printed((format, print), out));
        if format.is_picture { progress::told("this picture", write) } else { write() }?;
        Failure::of_open(open)
    }

    /// Writes everything and makes the file appear. A reader that closes the pipe early is no failure.
    pub(super) fn write(
        self,
        report: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), Failure> {
        let write = |out: &mut dyn Write| {
            let mut out = BufWriter::new(out);
            report(&mut out)?;
            out.flush()
        };
        match self {
            Self::Standard => match line::write(write) {
                Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
                result => result,
            }
            .map_err(|error| Failure::writing("to standard output", &error)),
            Self::Stream { mut stream, path } => {
                write(&mut stream).map_err(|error| cannot_write(&path, &error))
            }
            Self::File { unfinished: (unfinished, mut file), path, is_foreign } => {
                let failed = |error: io::Error| cannot_write(&path, &error);
                write(&mut file).map_err(failed)?;
                // The name must not be there before the content is.
                file.sync_all().map_err(failed)?;
                match is_foreign {
                    true => copy_into(unfinished.path(), &path),
                    false => unfinished.appear(&path),
                }
                .map_err(failed)
            }
        }
    }
}

fn cannot_write(path: &Path, error: &io::Error) -> Failure {
    Failure::writing(path.display(), error)
}

/// Gives a new file the owner and the permissions of the one that it will replace, but what lets a program run as its
/// owner, as whoever writes into a file takes that away; `false` if the owner cannot be given away.
fn take_over(there: &fs::Metadata, new: &File) -> io::Result<bool> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::{MetadataExt, fchown};
        let own = new.metadata()?;
        let same = (there.uid(), there.gid()) == (own.uid(), own.gid());
        if !same && fchown(new, Some(there.uid()), Some(there.gid())).is_err() {
            return Ok(false);
        }
    }
    #[cfg_attr(not(unix), allow(unused_mut, reason = "there are no modes elsewhere"))]
    let mut permissions = there.permissions();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        permissions.set_mode(permissions.mode() & 0o777);
    }
    new.set_permissions(permissions)?;
    Ok(true)
}

/// Writes the content of a finished file into another, whose owner it keeps.
fn copy_into(finished: &Path, path: &Path) -> io::Result<()> {
    let mut file = File::options().write(true).truncate(true).open(path)?;
    io::copy(&mut File::open(finished)?, &mut file)?;
    file.sync_all()
}
