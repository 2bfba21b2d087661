// Counts in the page's attributes what went wrong: an error, a message of it on the console, something that the page's policy forbids.

const root = document.documentElement;
const count = () => {
  root.dataset.errors = String(Number(root.dataset.errors) + 1);
};
addEventListener('error', count);
addEventListener('unhandledrejection', count);
addEventListener('securitypolicyviolation', count);
for (const kind of ['error', 'warn']) {
  const said = console[kind].bind(console);
  console[kind] = (...words) => {
    count();
    said(...words);
  };
}
