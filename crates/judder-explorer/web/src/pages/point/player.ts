/** Plays one sound at a time, without clicks. */

import { RATE } from "./sound";

const RAMP = 0.02;

export class Player {
  private context: AudioContext | undefined;
  private playing: { source: AudioBufferSourceNode; gain: GainNode } | undefined;
  private level = 0.5;

  /** `onEnd` is told when it has ended by itself. */
  async play(samples: Float32Array<ArrayBuffer>, loops: boolean, onEnd: () => void): Promise<void> {
    this.stop();
    this.context ??= new AudioContext();
    const { context } = this;
    await context.resume();
    const buffer = context.createBuffer(1, samples.length, RATE);
    buffer.copyToChannel(samples, 0);
    const source = context.createBufferSource();
    const gain = context.createGain();
    source.buffer = buffer;
    source.loop = loops;
    source.connect(gain).connect(context.destination);
    gain.gain.setValueAtTime(0, context.currentTime);
    gain.gain.linearRampToValueAtTime(this.level, context.currentTime + RAMP);
    const playing = { source, gain };
    source.onended = () => {
      gain.disconnect();
      if (this.playing !== playing) return;
      this.playing = undefined;
      onEnd();
    };
    this.playing = playing;
    source.start();
  }

  stop(): void {
    const { playing, context } = this;
    this.playing = undefined;
    if (!playing || !context) return;
    ramp(playing.gain.gain, 0, context.currentTime);
    playing.source.stop(context.currentTime + 2 * RAMP);
  }

  /** From 0 to 1. */
  setVolume(level: number): void {
    this.level = level;
    if (this.playing && this.context) ramp(this.playing.gain.gain, level, this.context.currentTime);
  }

  close(): void {
    this.stop();
    void this.context?.close();
    this.context = undefined;
  }
}

function ramp(parameter: AudioParam, to: number, now: number): void {
  parameter.cancelScheduledValues(now);
  parameter.setValueAtTime(parameter.value, now);
  parameter.linearRampToValueAtTime(to, now + RAMP);
}
