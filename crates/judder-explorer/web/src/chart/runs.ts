/** Lines through rows of tables: only neighbours that belong together are joined, whatever a table holds one after the other. */

export interface Curve {
  readonly x: Float64Array;
  readonly y: Float64Array;
}

interface Columns {
  readonly x: ArrayLike<number>;
  readonly y: ArrayLike<number>;
}

/** A line through neighbouring rows, with a gap wherever `joins(row)` does not say that the next row goes on from this one. */
export function through({ x, y }: Columns, joins: (row: number) => boolean): Curve {
  const runs: number[][] = [];
  let run: number[] | undefined;
  for (let row = 0; row + 1 < x.length; row += 1) {
    if (!joins(row)) {
      run = undefined;
      continue;
    }
    if (!run) runs.push((run = [row]));
    run.push(row + 1);
  }
  const taken = (values: ArrayLike<number>, run: readonly number[]) => Float64Array.from(run, (row) => values[row] as number);
  return apart(runs.map((run) => ({ x: taken(x, run), y: taken(y, run) })));
}

/** Lines one after the other as one, with a gap after each. */
export function apart(lines: readonly Columns[]): Curve {
  const length = lines.reduce((sum, line) => sum + line.x.length + 1, 0);
  const [x, y] = [new Float64Array(length).fill(Number.NaN), new Float64Array(length).fill(Number.NaN)];
  let start = 0;
  for (const line of lines) {
    x.set(line.x, start);
    y.set(line.y, start);
    start += line.x.length + 1;
  }
  return { x, y };
}
