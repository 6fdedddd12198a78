//! The page is one file that asks for nothing, escapes everything and has a fallback for every figure.

use crate::samples::{HOSTILE, every_layer, one_line};
use judder_report::page::{Check, Claim, ClaimVerdict, Code, Details, PageTable, Scoreboard};
use judder_report::{Page, PageBlock, PageSection, ReportError, Scale, html};

fn every_block(text: &str) -> Page {
    let owned = || text.to_owned();
    let claim = |verdict| Claim {
        place: owned(),
        says: owned(),
        ours: vec![owned(), owned()],
        verdict,
        why: owned(),
    };
    let check = Check { name: owned(), compared: owned(), figure: owned(), limit: owned(), passed: true };
    let blocks = vec![
        PageBlock::Heading(owned()),
        PageBlock::text(text),
        PageBlock::figure(every_layer(text)),
        PageBlock::Table(PageTable {
            caption: owned(),
            head: vec![owned()],
            rows: vec![vec![owned(), "1.5".to_owned()]],
        }),
        PageBlock::Scoreboard(Scoreboard {
            ours: vec![owned(), owned()],
            judged: 1,
            rows: [ClaimVerdict::Agrees, ClaimVerdict::Agrees, ClaimVerdict::Misprint, ClaimVerdict::Open]
                .map(claim)
                .into(),
        }),
        PageBlock::Checks(vec![check.clone(), Check { passed: false, ..check }]),
        PageBlock::Warnings(vec![owned()]),
        PageBlock::Warnings(vec![]),
        PageBlock::Details(Details {
            summary: owned(),
            blocks: vec![PageBlock::Code(Code { caption: owned(), text: owned() })],
        }),
    ];
    Page {
        title: owned(),
        lead: owned(),
        facts: vec![(owned(), owned())],
        sections: vec![PageSection::new(text, blocks)],
    }
}

/// The page without its scripts and style, whose insides are not markup.
fn markup_of(page: &str) -> String {
    let mut rest = page;
    let mut markup = String::new();
    while let Some(start) = ["<script", "<style"].iter().filter_map(|tag| rest.find(tag)).min() {
        let end = if rest[start..].starts_with("<script") { "</script>" } else { "</style>" };
        markup.push_str(&rest[..start]);
        let length = rest[start..].find(end).unwrap() + end.len();
        rest = &rest[start + length..];
    }
    markup + rest
}

/// Makes the few void elements and bare attributes of our HTML into XML, which can be parsed strictly.
fn as_xml(markup: &str) -> String {
    let mut xml = markup.replace("<!DOCTYPE html>", "").replace(" hidden ", " ").replace(" data-plot>", ">");
    for void in ["<meta charset=\"utf-8\">", "initial-scale=1\">", "content=\"light dark\">"] {
        xml = xml.replace(void, &void.replace('>', "/>"));
    }
    xml
}

#[test]
fn every_block_with_hostile_texts_is_well_formed() {
    let page = html(&every_block(HOSTILE)).unwrap();
    let markup = as_xml(&markup_of(&page));
    let document = roxmltree::Document::parse(&markup).unwrap_or_else(|error| panic!("{error}"));
    assert!(document.descendants().any(|node| node.attribute("class") == Some("warnings")));
    // one for the page and one for the figure's data: no text has opened or closed another
    assert_eq!(page.matches("<script").count(), 2);
    assert_eq!(page.matches("</script>").count(), 2);
}

#[test]
fn nothing_is_fetched() {
    let page = html(&every_block("text")).unwrap();
    let markup = markup_of(&page);
    for fetch in ["src=", "srcset=", "<link", "<iframe", "@import", "action=", "poster="] {
        assert!(!markup.contains(fetch), "{fetch}");
    }
    for reference in markup.split("href=\"").skip(1) {
        let inside =
            ["#", "figures/", "data:image/png;base64,"].iter().any(|start| reference.starts_with(start));
        assert!(inside, "{}", &reference[..40]);
    }
    let style = &page[page.find("<style").unwrap()..page.find("</style>").unwrap()];
    assert!(style.split("url(").skip(1).all(|address| address.starts_with("data:")));
    assert!(!style.contains("@import"));
    let script = &page[page.rfind("<script>").unwrap()..];
    for fetch in ["fetch(", "XMLHttpRequest", "WebSocket", "sendBeacon", "import(", "EventSource"] {
        assert!(!script.contains(fetch), "the chart asks for nothing: {fetch}");
    }
}

#[test]
fn headings_and_contents_are_in_order() {
    let page = Page {
        title: "Title".to_owned(),
        sections: vec![PageSection::new("One", vec![]), PageSection::new("Two", vec![])],
        ..Page::default()
    };
    let page = html(&page).unwrap();
    assert_eq!(page.matches("<h1>").count(), 1);
    for (number, title) in [(1, "One"), (2, "Two")] {
        assert!(page.contains(&format!("<a href=\"#section-{number}\">{title}</a>")));
        assert!(page.contains(&format!("<section id=\"section-{number}\"")));
    }
    assert!(page.len() < 200_000, "a page without figures carries no chart");
}

#[test]
fn counts_stand_at_the_head() {
    let page = html(&every_block("text")).unwrap();
    for count in
        ["4 claims", "2 agree<", "1 misprinted", "1 open", "2 checks", "1 passed", "1 failed", "No warnings."]
    {
        assert!(page.contains(count), "{count}");
    }
}

#[test]
fn a_figure_has_its_drawing_its_files_and_its_number() {
    let page = html(&every_block("text")).unwrap();
    assert!(page.contains("<div class=\"still\"><svg") && page.contains("<noscript>"));
    assert!(
        page.contains("href=\"figures/every-layer.svg\"")
            && page.contains("href=\"figures/every-layer.png\"")
    );
    assert!(page.contains("Figure 1."));
}

#[test]
fn two_figures_of_one_name_are_refused() {
    let figure = || PageBlock::figure(one_line(Scale::Linear, vec![], vec![]));
    let page = Page { sections: vec![PageSection::new("", vec![figure(), figure()])], ..Page::default() };
    assert_eq!(html(&page), Err(ReportError::SameName { name: "line".to_owned() }));
}

#[test]
fn the_same_page_gives_the_same_bytes() {
    assert_eq!(html(&every_block("$τ̃_{0}$")), html(&every_block("$τ̃_{0}$")));
}
