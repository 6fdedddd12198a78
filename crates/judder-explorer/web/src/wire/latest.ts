/**
 * At most one piece of work at a time, and the newest waiting.
 *
 * A drag asks faster than answers come. Aborting at each step would show nothing until it ends, so the work in flight may
 * go on until it has shown something (`shown`), or until its patience is over.
 */
export type Work = (signal: AbortSignal, shown: () => void) => Promise<void>;

export class Latest {
  private running: { abort: AbortController; hasShown: boolean } | undefined;
  private waiting: Work | undefined;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly patience = 600) {}

  /** Starts the work, or lets it wait in place of what waited. */
  submit(work: Work): void {
    if (!this.running) return void this.run(work);
    this.waiting = work;
    if (this.running.hasShown) this.running.abort.abort();
    else this.timer ??= setTimeout(() => this.running?.abort.abort(), this.patience);
  }

  /** Gives up what runs and what waits. */
  stop(): void {
    this.waiting = undefined;
    this.running?.abort.abort();
  }

  private async run(work: Work): Promise<void> {
    const running = { abort: new AbortController(), hasShown: false };
    this.running = running;
    const shown = () => {
      running.hasShown = true;
      if (this.waiting) running.abort.abort();
    };
    try {
      // work tells its own errors; what it leaves over is an abort
      await work(running.abort.signal, shown).catch(() => undefined);
    } finally {
      clearTimeout(this.timer);
      this.timer = undefined;
      this.running = undefined;
      const next = this.waiting;
      this.waiting = undefined;
      if (next) void this.run(next);
    }
  }
}
