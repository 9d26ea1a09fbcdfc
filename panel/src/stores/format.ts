// Numbers and times as the page shows them: as wide as the largest of their column, never jumping.
import { t } from '../text/text';

const minus = '\u2212';

/** Fixed decimals, a real minus sign, and no negative zero. */
export function fixed(value: number, decimals: number): string {
  const text = Math.abs(value).toFixed(decimals);
  const isZero = Number(text) === 0;
  return value < 0 && !isZero ? minus + text : text;
}

/** What a person wrote as a number, with comma or point; null when it is none. */
export function numberIn(text: string): number | null {
  const plain = text.replace(minus, '-').replace(',', '.').trim();
  return /^[-+]?(\d+\.?\d*|\.\d+)$/.test(plain) ? Number(plain) : null;
}

export const length = (value: number): string => fixed(value, 3);

/** 75 is 1:15, 3,700 is 1:01:40. */
export function duration(seconds: number): string {
  const whole = Math.max(0, Math.round(seconds));
  const two = (value: number): string => String(value).padStart(2, '0');
  const hours = Math.floor(whole / 3600);
  const minutes = Math.floor(whole / 60) % 60;
  const rest = two(whole % 60);
  return hours > 0 ? `${hours}:${two(minutes)}:${rest}` : `${minutes}:${rest}`;
}

export function clock(milliseconds: number): string {
  return new Date(milliseconds).toTimeString().slice(0, 8);
}

/** A time of Unix in s: of today the time alone. */
export function moment(time_s: number): string {
  const isToday = new Date(time_s * 1000).toDateString() === new Date().toDateString();
  return dateAndTime(time_s).slice(isToday ? 11 : 0, 16);
}

/** 2026-03-01 14:05:09, as the clock on the wall shows it. */
export function dateAndTime(time_s: number): string {
  const then = new Date(time_s * 1000);
  const day = [then.getFullYear(), then.getMonth() + 1, then.getDate()];
  const date = day.map((value) => String(value).padStart(2, '0')).join('-');
  return `${date} ${clock(time_s * 1000)}`;
}

export function bytes(count: number): string {
  if (count < 1000) return `${count} ${t('unit.b')}`;
  if (count < 1e6) return `${(count / 1e3).toFixed(1)} ${t('unit.kb')}`;
  return `${(count / 1e6).toFixed(1)} ${t('unit.mb')}`;
}

/** Axis words A, B and C turn. */
export const isRotary = (word: string): boolean => /^[ABC]/.test(word);
