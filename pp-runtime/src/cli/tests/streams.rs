//! Tests with files, links, devices and pipes, and of errors in reading and writing them.

use super::*;

#[test]
fn standard_input_is_spooled_and_read_twice() {
    let outcome = run_with(&["post", "-", "--no-check"], b"GOTO/1,2,3\n", &|job, source, sink, line_map| {
        assert_eq!(job.cl_name, "standard input");
        echo(job, source, sink, line_map)
    });
    assert_eq!(outcome.status, Status::Done);
    assert_eq!(outcome.output, ";GOTO/1,2,3\n");
}

#[test]
fn a_rejected_program_on_standard_output_is_status_1() {
    let outcome = run_with(&["post", "-", "-o", "-"], b"A\nGOTO/1\n", &fails_in_line_2);
    assert_eq!(outcome.status, Status::Rejected);
    assert_eq!(outcome.output, "G0 X0\n(error)\n");
    assert!(outcome.errors.contains("<stdin>:2:6: error: "), "{}", outcome.errors);
    assert!(outcome.errors.contains("must not be run"), "{}", outcome.errors);
}

#[test]
fn a_rejected_program_that_cannot_be_written_is_named() {
    let shop = Shop::new();
    fs::create_dir(shop.path("part.ngc.rejected")).expect("a folder");
    let outcome = shop.post(&[], &fails_in_line_2);
    assert_eq!(outcome.status, Status::NotRun);
    assert!(outcome.errors.contains("part.ngc.rejected: "), "{}", outcome.errors);
}

#[test]
fn a_configuration_that_is_far_too_large_is_not_read() {
    let shop = Shop::new();
    shop.write("large.toml", &"#\n".repeat(600_000));
    let config = shop.arg("large.toml");
    let outcome = run_with(&["post", &shop.arg("part.cls"), "-o", "-", "--config", &config], b"", &never);
    assert_eq!(outcome.status, Status::NotRun);
    assert!(outcome.errors.contains(&format!("cannot read {config}: it is larger than 1 MiB")), "{}", outcome.errors);
}

#[test]
fn unreadable_cl_data_is_status_2() {
    let shop = Shop::new();
    let missing = shop.arg("missing.cls");
    let outcome = run_with(&["post", &missing], b"", &never);
    assert_eq!(outcome.status, Status::NotRun);
    assert!(outcome.errors.starts_with(&format!("error: cannot read {missing}: ")), "{}", outcome.errors);
    let directory = shop.directory.path().display().to_string();
    let outcome = run_with(&["post", &directory], b"", &never);
    assert_eq!(outcome.status, Status::NotRun);
    assert!(outcome.errors.contains("is a directory"), "{}", outcome.errors);
}

#[test]
fn an_unwritable_program_is_status_2_before_anything_is_posted() {
    let shop = Shop::new();
    let (input, output) = (shop.arg("part.cls"), shop.arg("nowhere/part.ngc"));
    let outcome = run_with(&["post", &input, "-o", &output], b"", &never);
    assert_eq!(outcome.status, Status::NotRun);
    assert!(outcome.errors.starts_with(&format!("error: cannot write {output}: ")), "{}", outcome.errors);
}

#[test]
fn a_failing_read_or_write_is_status_2_and_leaves_the_earlier_program() {
    for (error, words) in [
        (PostError::Input as fn(io::Error) -> PostError, "error: cannot read "),
        (PostError::Output as fn(io::Error) -> PostError, "error: cannot write "),
    ] {
        let shop = Shop::new();
        shop.write("part.ngc", "yesterday");
        let outcome = shop.post(&[], &|_, _, _, _| Err(error(io::Error::other("the disk is gone"))));
        assert_eq!(outcome.status, Status::NotRun);
        assert!(outcome.errors.starts_with(words) && outcome.errors.contains("the disk is gone"));
        assert_eq!(shop.names(), ["part.cls", "part.ngc"]);
        assert_eq!(shop.text("part.ngc"), "yesterday");
    }
}

/// A pipe whose other end is closed.
struct ClosedPipe;

impl Write for ClosedPipe {
    fn write(&mut self, _bytes: &[u8]) -> io::Result<usize> {
        Err(io::ErrorKind::BrokenPipe.into())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_closed_pipe_is_status_2_without_a_message() {
    for words in [&["post", "-", "--no-check"][..], &["config"], &["explain"], &["--help"]] {
        let args: Vec<OsString> = ["sample"].iter().chain(words).map(OsString::from).collect();
        let mut errors = Vec::new();
        let streams =
            Streams { input: &mut &b"A\n"[..], output: &mut ClosedPipe, errors: &mut errors, terminal: false };
        assert_eq!(execute(&Sample::default(), &[], &args, streams, &echo), Status::NotRun, "{words:?}");
        assert_eq!(String::from_utf8_lossy(&errors), "", "{words:?}");
    }
}

#[test]
fn the_program_never_replaces_a_file_that_is_read() {
    let shop = Shop::new();
    shop.write("shop.toml", "");
    shop.write("part.rejected", "A\n");
    let (part, toml) = (shop.arg("part.cls"), shop.arg("shop.toml"));
    for args in [
        vec!["post", &part, "-o", &part],
        vec!["post", &part, "-o", &toml, "--config", &toml],
        vec!["post", &shop.arg("part.rejected"), "-o", &shop.arg("part")],
        vec!["post", &part, "-o", &format!("{}/./part.cls", shop.directory.path().display())],
    ] {
        let outcome = run_with(&args, b"", &never);
        assert_eq!(outcome.status, Status::NotRun, "{args:?}");
        assert!(outcome.errors.contains(" would overwrite the "), "{}", outcome.errors);
    }
    assert_eq!(shop.text("part.cls"), "PARTNO A\nGOTO/1.0\n");
}

#[cfg(unix)]
#[test]
fn a_link_to_the_cl_data_is_the_cl_data() {
    let shop = Shop::new();
    std::os::unix::fs::symlink(shop.path("part.cls"), shop.path("soft")).expect("links work here");
    fs::hard_link(shop.path("part.cls"), shop.path("hard")).expect("links work here");
    for link in ["soft", "hard"] {
        let outcome = run_with(&["post", &shop.arg("part.cls"), "-o", &shop.arg(link)], b"", &never);
        assert_eq!(outcome.status, Status::NotRun);
    }
}

#[cfg(unix)]
#[test]
fn a_link_stays_a_link_and_its_target_is_replaced() {
    let shop = Shop::new();
    shop.write("real.ngc", "yesterday");
    std::os::unix::fs::symlink(shop.path("real.ngc"), shop.path("part.ngc")).expect("links work here");
    assert_eq!(shop.post(&[], &echo).status, Status::Done);
    assert!(fs::symlink_metadata(shop.path("part.ngc")).expect("the link is there").is_symlink());
    assert_eq!(shop.text("real.ngc"), ";PARTNO A\nGOTO/1.0\n");
}

#[cfg(unix)]
#[test]
fn a_device_is_written_and_not_replaced() {
    let shop = Shop::new();
    let outcome = run_with(&["post", &shop.arg("part.cls"), "-o", "/dev/null", "--no-check"], b"", &echo);
    assert_eq!(outcome.status, Status::Done, "{}", outcome.errors);
    assert!(!fs::metadata("/dev/null").expect("it is there").is_file());
}

#[cfg(unix)]
#[test]
fn a_stream_whose_first_line_has_no_end_is_refused() {
    let shop = Shop::new();
    let outcome = run_with(&["post", "/dev/zero", "-o", &shop.arg("part.ngc")], b"", &echo);
    assert!(outcome.errors.contains("a line of more than 1 MiB"), "{}", outcome.errors);
    assert!(!shop.path("part.ngc").exists());
}

#[test]
fn cl_data_that_changes_or_vanishes_meanwhile_is_status_2() {
    let changes: [fn(&Path); 2] =
        [|path| fs::write(path, "GOTO/9,9,9,9\n").expect("writable"), |path| fs::remove_file(path).expect("there")];
    for (change, words) in changes.into_iter().zip(["changed while it was read", "was removed while it was read"]) {
        let shop = Shop::new();
        shop.write("part.ngc", "yesterday");
        let outcome = shop.post(&[], &|job, source, sink, line_map| {
            let report = echo(job, source, sink, line_map)?;
            change(&shop.path("part.cls"));
            Ok(report)
        });
        assert_eq!(outcome.status, Status::NotRun);
        assert!(outcome.errors.contains(words), "{}", outcome.errors);
        assert_eq!(shop.text("part.ngc"), "yesterday");
        assert!(!shop.path("part.ngc.rejected").exists());
    }
}
