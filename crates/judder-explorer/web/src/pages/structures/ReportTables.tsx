/** The tables of a report. */

import { plainText } from "../../chart/markup";
import { Label } from "../../ui/Label";
import type { ReportTable } from "./useReport";

export function ReportTables({ tables }: { readonly tables: readonly ReportTable[] }) {
  return (
    <>
      {tables.map((table, index) => (
        // what is wider than the page is scrolled within its own place, by the keyboard too
        <div class="report-table" key={index} tabIndex={0} role="region" aria-label={plainText(table.caption) || `Table ${index + 1}`}>
          <table class="study-table">
            {table.caption && (
              <caption>
                <Label text={table.caption} />
              </caption>
            )}
            {table.head.some((cell) => cell !== "") && (
              <thead>
                <tr>{table.head.map((cell, column) => (cell === "" ? <td key={column} /> : <th scope="col" key={column}><Label text={cell} /></th>))}</tr>
              </thead>
            )}
            <tbody>
              {table.rows.map((row, place) => (
                <tr key={place}>
                  {row.map((cell, column) =>
                    column === 0 && cell !== "" ? <th scope="row" key={column}><Label text={cell} /></th> : <td key={column}><Label text={cell} /></td>,
                  )}
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      ))}
    </>
  );
}
