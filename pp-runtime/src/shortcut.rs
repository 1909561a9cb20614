//! Shortcuts: fast paths beside plain ones, each with its name.
//!
//! A shortcut gives the bytes, findings and figures of the plain path, only sooner (`docs/notes-on-speed.md` says how
//! much). A fast path without its name here is an error. With debug assertions a test may switch shortcuts off, in its
//! own thread: [`without`].

#[cfg(debug_assertions)]
use std::cell::Cell;

macro_rules! shortcuts {
    ($($(#[$doc:meta])* $name:ident,)*) => {
        /// A fast path beside a plain one.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Shortcut {
            $($(#[$doc])* $name,)*
        }

        impl Shortcut {
            /// All shortcuts.
            pub const ALL: &[Self] = &[$(Self::$name,)*];
        }
    };
}

shortcuts! {
    /// The reader takes a GOTO, or a CIRCLE and its GOTO, on lines of their own directly from the text, without the
    /// table of words.
    LinesOfNumbers,
    /// The reader takes the numbers of a line that has its digits where the line before had them, without looking for
    /// their ends.
    LineShapes,
    /// The course takes a run of cuts in which each state comes from the one before by one sum for each branch.
    SteadyRuns,
    /// The course takes a cut that rotates every axis by less than a quarter of a revolution state by state, without a
    /// search.
    StatesFollowed,
    /// The course takes a motion with the tool axis of the one before without asking for branches.
    HeldToolAxis,
    /// The placer keeps the rotary words of a motion after one that kept them with the same tool axis.
    RotariesAtRest,
    /// The travel along an arc is within that needed so far where its reach is.
    TravelInReach,
    /// The mover certifies a motion as one block by bounds, without copies, before it divides it.
    OneBlock,
    /// The check takes a line of axis words and F directly from the text, and lets them move the axes.
    LinesOfWords,
    /// The check bounds the deviation between the ends of a block, and measures at points only where the bound does not
    /// decide.
    DeviationBounds,
    /// The check judges F of a block by bounds of the speed of its tip, where they decide.
    FeedBounds,
    /// The check compares the modal state only of a block after which it may be another than before.
    SameModes,
}

#[cfg(debug_assertions)]
thread_local! {
    static OFF: Cell<u32> = const { Cell::new(0) };
}

impl Shortcut {
    /// Whether it may be taken.
    #[inline(always)]
    pub(crate) fn is_on(self) -> bool {
        #[cfg(debug_assertions)]
        return OFF.get() & (1 << self as u32) == 0;
        #[cfg(not(debug_assertions))]
        return true;
    }
}

/// Runs with these shortcuts off, in this thread.
#[cfg(debug_assertions)]
pub fn without<T>(off: &[Shortcut], run: impl FnOnce() -> T) -> T {
    struct Restored(u32);
    impl Drop for Restored {
        fn drop(&mut self) {
            OFF.set(self.0);
        }
    }
    let _restored = Restored(OFF.replace(off.iter().fold(0, |bits, shortcut| bits | 1 << *shortcut as u32)));
    run()
}
