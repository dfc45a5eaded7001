// The scenes of pages that do not run themselves: each plays the frames that were woven with it, which are fetched when they are
// first wanted.
import { Moving } from './scene.mjs';

for (const figure of document.querySelectorAll('figure[data-frames]')) {
  const { scene, frames: src } = figure.dataset;
  const told = () =>
    new Promise((taken, failed) => {
      const script = document.createElement('script');
      const onload = () => taken(self.SCENES[scene]);
      const onerror = () => failed(new Error(`${src} is missing`));
      document.head.append(Object.assign(script, { src, onload, onerror }));
    });
  new Moving(figure, told);
}
self.liveListens = true;
self.liveWanted?.click();
