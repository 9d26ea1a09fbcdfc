// A canvas that fits its place: as sharp as the screen, and in pixels of a usual one, so that texts and
// lines grow with everything else on a large screen.
import { magnification } from '../style/resolved';

export interface Fitted {
  context: CanvasRenderingContext2D;
  width: number;
  height: number;
}

export function contextOf(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
  const context = canvas.getContext('2d');
  if (context === null) throw new Error('this browser draws no pictures');
  return context;
}

/** Sizes of the place in pixels of the page. */
export function fitted(canvas: HTMLCanvasElement, width: number, height: number): Fitted {
  const context = contextOf(canvas);
  const zoom = magnification();
  const scale = window.devicePixelRatio * zoom;
  canvas.width = Math.round(width * window.devicePixelRatio);
  canvas.height = Math.round(height * window.devicePixelRatio);
  context.setTransform(scale, 0, 0, scale, 0, 0);
  return { context, width: width / zoom, height: height / zoom };
}
