//! The page of the gallery, with a block of every kind.

use judder_report::page::{Check, Claim, ClaimVerdict, Code, Details, PageTable, Scoreboard};
use judder_report::{Figure, Page, PageBlock, PageSection};

/// A page around these figures.
pub(crate) fn page(figures: Vec<Figure>) -> Page {
    Page {
        title: "The oscillator paper, reproduced".to_owned(),
        lead: "Figures 4 to 10 of Critical thresholds for mode-coupling instability in viscoelastic sliding contacts, \
               recomputed from invented curves: this page shows what a report looks like, not what an oscillator does."
            .to_owned(),
        facts: [("judder", "0.1.0"), ("Case", "b3:9f2c41d07a"), ("Wall time", "3.4 s"), ("Friction", "$F_{n} μ$ and $F_{k} μ$")]
            .map(|(name, value)| (name.to_owned(), value.to_owned()))
            .into(),
        sections: vec![
            PageSection::new("Scoreboard", vec![
                PageBlock::text("Every number that the paper's text quotes, beside ours with both readings of the friction force."),
                PageBlock::Scoreboard(scoreboard()),
            ]),
            PageSection::new("Figures", figures.into_iter().map(PageBlock::figure).collect()),
            PageSection::new("Checks", vec![PageBlock::Checks(checks()), PageBlock::Table(table())]),
            PageSection::new("Warnings", vec![PageBlock::Warnings(vec![
                "12 of 48 000 cells of stability-map did not resolve and are hatched: the equilibrium stopped at \
                 $v̂_{d}$ > 40, $τ̃_{0}$ > 0.5 with a residual of 3 × 10^{−7}."
                    .to_owned(),
            ])]),
            PageSection::new("Case", vec![
                PageBlock::text("The case as it was run; what it leaves out takes the paper's value."),
                PageBlock::Details(Details { summary: "Case file".to_owned(), blocks: vec![case_file()] }),
            ]),
        ],
    }
}

fn claim(place: &str, says: &str, ours: [&str; 2], verdict: ClaimVerdict, why: &str) -> Claim {
    Claim {
        place: place.to_owned(),
        says: says.to_owned(),
        ours: ours.map(str::to_owned).into(),
        verdict,
        why: why.to_owned(),
    }
}

fn scoreboard() -> Scoreboard {
    Scoreboard {
        ours: vec!["ours, $F_{n} μ$".to_owned(), "ours, $F_{k} μ$".to_owned()],
        judged: 1,
        rows: vec![
            claim(
                "Sec. 4.2, Fig. 5",
                "$τ̃_{0,crit}$ ≈ 3.5 × 10^{−2}",
                ["3.48 × 10^{−2}", "3.51 × 10^{−2}"],
                ClaimVerdict::Agrees,
                "Both readings give the paper's number.",
            ),
            claim(
                "Sec. 4.2, Fig. 6",
                "the modes merge at 7.5 × 10^{−7}",
                ["7.1 × 10^{−8}", "7.0 × 10^{−8}"],
                ClaimVerdict::Misprint,
                "The exponent: the conservative modes merge near 7 × 10^{−8}.",
            ),
            claim(
                "Sec. 5",
                "stable for all $τ̃_{0}$ ≲ 2 × 10^{−3}",
                ["1.6 × 10^{−4}", "2.1 × 10^{−3}"],
                ClaimVerdict::Open,
                "Only the contact-force reading gives it; the print has the other.",
            ),
        ],
    }
}

fn checks() -> Vec<Check> {
    let check = |name: &str, compared: &str, figure: &str, limit: &str, passed: bool| Check {
        name: name.to_owned(),
        compared: compared.to_owned(),
        figure: figure.to_owned(),
        limit: limit.to_owned(),
        passed,
    };
    vec![
        check(
            "Jacobian",
            "C and K against finite differences, 1 000 points",
            "3.1 × 10^{−8}",
            "≤ 10^{−6}",
            true,
        ),
        check(
            "Stability decision",
            "Hurwitz sign against eigenvalues, 100 000 points",
            "0 mismatches",
            "0",
            true,
        ),
        check("Growth", "eigenvalue against a transient, 3 points", "2.4 %", "≤ 1 %", false),
    ]
}

fn table() -> PageTable {
    let row = |cells: [&str; 4]| cells.map(str::to_owned).to_vec();
    PageTable {
        caption: "Share of the unstable area by mechanism, in per cent.".to_owned(),
        head: row(["Map", "flutter", "negative damping", "both"]),
        rows: vec![row(["Fig. 9a", "41.2", "30.1", "22.4"]), row(["Fig. 9b", "38.0", "35.6", "20.9"])],
    }
}

fn case_file() -> PageBlock {
    PageBlock::Code(Code {
        caption: "fig-9a.toml".to_owned(),
        text: "title = \"Fig. 9a of the oscillator paper\"\nmodel = \"oscillator\"\n\n[operation]\nvelocity    = 1e-4\n\
               normal_load = 1e-6   # F_n / (E0* R²)\n\n[[analysis]]\nname = \"map\"\nkind = \"stability-map\"\n\
               x = { key = \"operation.velocity\", from = 1e-8, to = 1e2, points = 400, scale = \"log\" }\n"
            .to_owned(),
    })
}
