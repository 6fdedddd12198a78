import { render } from "preact";
import { pageOf } from "./pages";
import { PAGES } from "./state/view";
import "./styles.css";
import "./ui/ui.css";
import "./chart/chart.css";
import { Start } from "./ui/Start";
import { startTheme } from "./ui/theme";

startTheme();
// the page of the address comes while the session is asked for
const named = PAGES.find((name) => location.pathname === `/${name}`) ?? "map";
void pageOf[named]().catch(() => undefined);
const page = document.getElementById("page");
if (page) render(<Start />, page);
