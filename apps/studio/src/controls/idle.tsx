/** Why a control has no effect at the moment: under it for the eye, and its description for a screen reader. */
export function Idle({ id, why }: { id: string; why: string }) {
  return (
    <p id={`${id}-idle`} class="idle">
      {why}
    </p>
  );
}
