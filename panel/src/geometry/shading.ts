// By what the moves at feed of a path may have their colours.
export const shadings = ['kind', 'feed', 'tool'] as const;
export type Shading = (typeof shadings)[number];
