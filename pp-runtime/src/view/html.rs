//! HTML documents: their begin, and escaped text.
//!
//! The content security policy of a document permits its script by its digest, and nothing from a network.

use std::fmt::{self, Display, Formatter};
use std::fs::File;
use std::io::{self, Read as _, Write};
use std::path::Path;

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use sha2::{Digest as _, Sha256};

/// Rights of a document besides its script: style and pictures of its own, no address and no form.
const RIGHTS: &str = "style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'";

/// The element by which a document is known to be one of ours.
const GENERATOR: &str = "<meta name=\"generator\" content=\"pp-runtime\">";

/// Bytes at the begin of a document in which that element is.
const BEGIN_BYTES: u64 = 256;

/// Whether a file is a page or a set-up sheet written earlier.
pub(crate) fn is_document(path: &Path) -> bool {
    let mut begin = Vec::new();
    let read = File::open(path).and_then(|file| file.take(BEGIN_BYTES).read_to_end(&mut begin));
    read.is_ok() && memchr::memmem::find(&begin, GENERATOR.as_bytes()).is_some()
}

/// Text between tags and in attributes.
pub(crate) struct Escaped<T>(pub(crate) T);

impl<T: Display> Display for Escaped<T> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.to_string().chars().try_for_each(|character| match character {
            '&' => f.write_str("&amp;"),
            '<' => f.write_str("&lt;"),
            '>' => f.write_str("&gt;"),
            '"' => f.write_str("&quot;"),
            '\'' => f.write_str("&#39;"),
            character => write!(f, "{character}"),
        })
    }
}

/// Begins a document. Only `script` may run in it.
pub(crate) fn begin(title: &str, style: &str, script: Option<&str>, out: &mut dyn Write) -> io::Result<()> {
    let digest = |script: &str| format!("; script-src 'sha256-{}'", BASE64_STANDARD.encode(Sha256::digest(script)));
    writeln!(
        out,
        "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\">{GENERATOR}\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'{}; {RIGHTS}\">\n\
         <title>{}</title>\n<style>{style}</style></head>\n<body>",
        script.map(digest).unwrap_or_default(),
        Escaped(title)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escaped_text_opens_and_closes_nothing() {
        let text = Escaped("</script><img src='x' onerror=\"f(1 & 2)\">").to_string();
        assert_eq!(text, "&lt;/script&gt;&lt;img src=&#39;x&#39; onerror=&quot;f(1 &amp; 2)&quot;&gt;");
    }

    #[test]
    fn only_the_script_of_the_page_may_run() {
        let policy = |script| {
            let mut out = Vec::new();
            begin("A <b>", "", script, &mut out).expect("memory");
            let text = String::from_utf8(out).expect("UTF-8");
            assert!(text.contains("<title>A &lt;b&gt;</title>"), "{text}");
            let (_, rest) = text.split_once("content=\"default-src 'none'").expect("a policy");
            rest.split_once('"').expect("it ends").0.to_owned()
        };
        assert_eq!(policy(None), format!("; {RIGHTS}"));
        // The digest of `alert(1)` by `openssl dgst -sha256 -binary | base64`.
        let digest = "bhHHL3z2vDgxUt0W3dWQOrprscmda2Y5pLsLg4GF+pI=";
        assert_eq!(policy(Some("alert(1)")), format!("; script-src 'sha256-{digest}'; {RIGHTS}"));
    }
}
