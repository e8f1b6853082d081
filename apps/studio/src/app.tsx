import { render } from 'preact';
import { Dividers } from './dividers.tsx';
import { DropTarget, followDrops } from './drop-target.tsx';
import { Help } from './help.tsx';
import { NoticeList } from './notice-list.tsx';
import { notify, reasonOf } from './notices.ts';
import { OpeningCard } from './opening/opening-card.tsx';
import { Panel } from './panel/panel.tsx';
import { ProblemsDialog } from './problems-dialog.tsx';
import { StatusLine } from './status-line.tsx';
import './styles/base.css';
import './styles/controls.css';
import './styles/panel.css';
import './styles/overlay.css';

function App() {
  return (
    <>
      <Dividers />
      <StatusLine />
      <NoticeList />
      <OpeningCard />
      <Panel />
      <Help />
      <ProblemsDialog />
      <DropTarget />
    </>
  );
}

/** Builds everything that lies over the picture. Errors from here on are shown and not only logged. */
export function mountApp(root: HTMLElement): void {
  render(<App />, root);
  followDrops();
  addEventListener('error', (event) => notify('error', (t) => t.noticeError(event.message)));
  addEventListener('unhandledrejection', (event) => notify('error', (t) => t.noticeError(reasonOf(event.reason))));
}
