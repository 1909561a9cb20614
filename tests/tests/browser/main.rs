//! The page of a program in Chromium, and its bundle made again by Node.

mod bundle;
mod pages;
