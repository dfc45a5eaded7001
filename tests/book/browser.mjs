// The browser in which the tests look at pages: Chromium as it is installed, or BROWSER. Without one the test says what was
// not tried and ends with status 77, which ctest takes as skipped; where CI is set that is a failure.
import fs from 'node:fs';
import { packages } from '../../book/packages.mjs';

/** A browser that asks the network for nothing; `more` are further arguments for it. */
export async function launch(untried, more = []) {
  const executablePath = [
    process.env.BROWSER,
    '/usr/bin/chromium',
    '/usr/bin/chromium-browser',
    '/usr/bin/google-chrome',
  ].find((p) => p && fs.existsSync(p));
  if (!executablePath) {
    console.error(`no browser (chromium): ${untried}`);
    process.exit(process.env.CI ? 1 : 77);
  }
  return packages('playwright-core').chromium.launch({
    executablePath,
    args: [
      '--no-sandbox',
      '--disable-gpu',
      '--disable-background-networking',
      '--disable-component-update',
      '--disable-sync',
      '--no-first-run',
      ...more,
    ],
  });
}
