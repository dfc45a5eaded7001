// The npm packages stand in the build tree, not beside these files: BOOK_PACKAGES names the folder of
// package.json.
import { createRequire } from 'node:module';
import path from 'node:path';

export const packages = createRequire(
  path.resolve(process.env.BOOK_PACKAGES ?? 'build/book/npm', 'package.json'),
);
