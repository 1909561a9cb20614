//! Converts feeds to mm/min or mm/rev, and refuses those that are not plausible.

use super::options::FeedLabel;
use super::units::FileUnits;
use crate::cl::record::{FeedRecord, FeedUnit};
use crate::cl::text::ClFault;
use crate::diag::code::cl;
use crate::program::{Feed, Units};

/// Smallest plausible feed; a smaller one is in another unit.
const SLOWEST_FEED_MM_PER_MIN: f64 = 0.1;

/// Largest plausible feed per revolution; a larger one is a feed per minute with a wrong label. Even a large face mill
/// stays below a fifth of it.
const LARGEST_FEED_MM_PER_REV: f64 = 100.0;

const MM_IN_A_FOOT: f64 = 304.8;

/// Largest plausible value of a feed in its own unit; a larger one has a wrong exponent.
const LARGEST_FEED: f64 = 1e6;

/// Feed of a record, converted from the unit of its label or of the file.
pub(crate) fn feed_of(record: &FeedRecord, units: &mut FileUnits, label: FeedLabel) -> Result<Feed, ClFault> {
    let FeedRecord { value, unit, at, unit_at } = *record;
    let of_file = units.millimetres(at)?;
    let in_millimetres = matches!(unit, FeedUnit::MillimetresPerMinute | FeedUnit::MillimetresPerRevolution);
    let doubtful = in_millimetres && units.known() == Some(Units::Inches);
    let millimetre = match label {
        FeedLabel::Refuse if doubtful => {
            return Err(cl::FEED.cl_fault(
                "feed unit",
                unit_at,
                "feed labelled in mm in a file in inch: such labels are often wrong",
                "state what its number is: `[cl] feed_label = \"trust\"` (mm, as labelled) or `\"file-units\"` (inch)",
            ));
        }
        FeedLabel::FileUnits if doubtful => of_file,
        FeedLabel::Refuse | FeedLabel::Trust | FeedLabel::FileUnits => 1.0,
    };
    let inch = Units::Inches.in_mm();
    let feed = match unit {
        FeedUnit::PerMinute => Feed::PerMinute(value * of_file),
        FeedUnit::PerRevolution => Feed::PerRevolution(value * of_file),
        FeedUnit::MillimetresPerMinute => Feed::PerMinute(value * millimetre),
        FeedUnit::MillimetresPerRevolution => Feed::PerRevolution(value * millimetre),
        FeedUnit::InchesPerMinute => Feed::PerMinute(value * inch),
        FeedUnit::InchesPerRevolution => Feed::PerRevolution(value * inch),
        FeedUnit::FeetPerMinute => Feed::PerMinute(value * MM_IN_A_FOOT),
        FeedUnit::FeetPerRevolution => Feed::PerRevolution(value * MM_IN_A_FOOT),
    };
    check(feed, record, units.known().unwrap_or_default())
}

/// Refuses a feed that is not plausible.
fn check(feed: Feed, record: &FeedRecord, units: Units) -> Result<Feed, ClFault> {
    let value = record.value;
    let fault = |text: String, help: &str| Err(cl::FEED.cl_fault("feed", record.at, text, help));
    match feed {
        _ if value <= 0.0 => fault(
            format!("the feed must be above 0, found {value}"),
            "set a feed for every cutting move in the CAM system",
        ),
        Feed::PerMinute(speed) if speed < SLOWEST_FEED_MM_PER_MIN => fault(
            format!("a feed of {} is not plausible", units.feed(speed)),
            "check the unit of the file and of the feed",
        ),
        Feed::PerRevolution(feed) if feed > LARGEST_FEED_MM_PER_REV => fault(
            format!("a feed of {} per revolution is not plausible", units.length(feed)),
            "check the unit of the feed: IPM, MMPM and PERMIN are per minute",
        ),
        Feed::PerMinute(_) | Feed::PerRevolution(_) if !value.is_finite() || value > LARGEST_FEED => {
            fault(format!("the feed {value:e} is not plausible"), "check the exponent of this number")
        }
        Feed::PerMinute(_) | Feed::PerRevolution(_) => Ok(feed),
    }
}
