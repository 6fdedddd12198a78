/**
 * At most one piece of work at a time, and the newest waiting.
 *
 * A drag asks faster than answers come. Aborting at each step would show nothing until it ends, so the work in flight may
 * go on until it has shown something (`shown`), or until its patience is over. What is aborted tells nothing more.
 */
export type Work = (signal: AbortSignal, shown: () => void) => Promise<void>;

export class Latest {
  private running: { readonly abort: AbortController; hasShown: boolean } | undefined;
  private waiting: Work | undefined;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly patience = 600) {}

  /** Starts the work, or lets it wait in place of what waited. */
  submit(work: Work): void {
    this.waiting = work;
    if (!this.running || this.running.hasShown) this.next();
    else this.timer ??= setTimeout(() => this.next(), this.patience);
  }

  /** Gives up what runs and what waits. */
  stop(): void {
    this.waiting = undefined;
    this.next();
  }

  /** Gives up what runs and starts what waits at once: the older may still unwind. */
  private next(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    const [old, work] = [this.running, this.waiting];
    this.running = this.waiting = undefined;
    old?.abort.abort();
    if (work) void this.run(work);
  }

  private async run(work: Work): Promise<void> {
    const running = { abort: new AbortController(), hasShown: false };
    this.running = running;
    const shown = () => {
      running.hasShown = true;
      if (this.running === running && this.waiting) this.next();
    };
    // work tells its own errors; what it leaves over is an abort
    await work(running.abort.signal, shown).catch(() => undefined);
    if (this.running === running) this.next();
  }
}
