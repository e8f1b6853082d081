import { Button } from './controls/button.tsx';
import { dictionary } from './i18n.ts';
import { dismiss, isBrief, notices } from './notices.ts';

/** Sentences over the picture: what went wrong, or why the picture is not what one expects. */
export function NoticeList() {
  const t = dictionary.value;
  return (
    <div id="notices" class="notices" role="status">
      {notices.value.map(({ subject, text }) => (
        <div
          key={subject}
          class={isBrief(subject) ? 'notice brief' : 'notice'}
          data-subject={subject}
          onAnimationEnd={() => dismiss(subject)}
        >
          <p>{text(t)}</p>
          <Button icon="close" kind="round" name={t.dismiss} onClick={() => dismiss(subject)} />
        </div>
      ))}
    </div>
  );
}
