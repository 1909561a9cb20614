//! The CAM systems whose CL data conventions are known.

/// The CAM system that wrote a file. Each has a record or comment that identifies it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Dialect {
    /// Not identified.
    #[default]
    Generic,
    /// Siemens NX: `TOOL PATH/`.
    Nx,
    /// CATIA: `$$*CATIA0`.
    Catia,
    /// PTC Creo: `$$->`.
    Creo,
    /// SolidWorks CAM: `UNIT/`, `CSYS/`, `TRNTYP/`, `CSI_`.
    SolidWorks,
    /// ISO 4343. No record identifies it, so it must be given (`--dialect iso`).
    Iso,
    /// The posts *Common ISO 4343 APT* and *CAMplete APT* of Autodesk (Fusion, Inventor CAM, HSMWorks). No record
    /// identifies them, so they must be given (`--dialect autodesk`).
    Autodesk,
}

impl Dialect {
    /// Names, as on the command line.
    pub const NAMES: [(&'static str, Dialect); 6] = [
        ("nx", Dialect::Nx),
        ("catia", Dialect::Catia),
        ("creo", Dialect::Creo),
        ("solidworks", Dialect::SolidWorks),
        ("iso", Dialect::Iso),
        ("autodesk", Dialect::Autodesk),
    ];

    /// Name for messages.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Dialect::Generic => "an unknown CAM system",
            Dialect::Nx => "NX",
            Dialect::Catia => "CATIA",
            Dialect::Creo => "Creo",
            Dialect::SolidWorks => "SolidWorks CAM",
            Dialect::Iso => "ISO 4343",
            Dialect::Autodesk => "Autodesk",
        }
    }
}
