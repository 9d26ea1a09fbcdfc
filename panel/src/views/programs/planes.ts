// Where the rotary axes will stand in the tilted planes of a program, as texts.
import type { Result } from '../../rpc/json_rpc';
import { fixed } from '../../stores/format';
import { t } from '../../text/text';

export type TiltedPlane = Result<'program.check'>['tilted_planes'][number];

/** A25 C−90.5: words and angles, in deg; at most four decimals. */
export function positionText(axes: Record<string, number>): string {
  return Object.entries(axes)
    .map(([word, angle]) => word + short(angle))
    .join(' ');
}

/** The direction of the tool on the table. */
export function directionText(tool: number[]): string {
  return tool.map((part, k) => 'XYZ'.charAt(k) + short(part)).join(' ');
}

/** What P1 or P2 would make of it; nothing: there is no other position. */
export function otherText({ other }: TiltedPlane): string {
  if (other === undefined) return '';
  const there = `${other.word}: ${positionText(other.axes)}`;
  if (other.limit === undefined) return there;
  const [axis] = Object.keys(other.axes);
  return t('planes.ends', { there, axis: axis ?? '', limit: short(other.limit) });
}

function short(value: number): string {
  return fixed(value, 4).replace(/\.?0+$/, '');
}
