/** A table of numbers, a row of which is picked by its first column. */

import { Digits } from "../../ui/Digits";
import { Label } from "../../ui/Label";

interface Column<Row> {
  readonly head: string;
  /** Where the numbers stand in the document they come from, before the row's own part. */
  readonly dataKey: (index: number) => string;
  readonly value: (row: Row) => number | null | undefined;
}

interface PickTableProps<Row> {
  readonly caption: string;
  readonly rows: readonly Row[];
  readonly columns: readonly Column<Row>[];
  readonly isPicked: (row: Row, index: number) => boolean;
  readonly onPick: (row: Row, index: number) => void;
}

export function PickTable<Row>({ caption, rows, columns, isPicked, onPick }: PickTableProps<Row>) {
  return (
    <div class="zone-table">
      <table class="study-table">
        <caption>{caption}</caption>
        <thead>
          <tr>
            {columns.map(({ head }) => (
              <th scope="col" key={head}>
                <Label text={head} />
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map((row, index) => (
            <tr key={index} class={isPicked(row, index) ? "picked" : ""}>
              {columns.map(({ head, dataKey, value }, column) => {
                const digits = <Digits dataKey={dataKey(index)} value={value(row)} />;
                return (
                  <td key={head}>
                    {column === 0 ? (
                      <button type="button" onClick={() => onPick(row, index)} title="Moves the cursor here">
                        {digits}
                      </button>
                    ) : (
                      digits
                    )}
                  </td>
                );
              })}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
