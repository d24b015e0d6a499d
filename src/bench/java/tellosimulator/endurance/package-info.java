/**
 * Attacks on the runnable jar, as processes of their own, and what they do to it.
 *
 * <p>{@link tellosimulator.endurance.Endurance} runs them and prints a table; see
 * docs/endurance.md. Each {@code *Trial} is one row or a few that belong together. Whoever takes
 * part in a trial on another machine of a private network (pilot, stranger) is a program with a
 * {@code main} of its own, which reports in lines on its standard output.
 */
package tellosimulator.endurance;
