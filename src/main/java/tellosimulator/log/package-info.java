/**
 * The log on standard error.
 *
 * <p>{@link tellosimulator.log.LogSetup} configures Logback: it uses a queue, {@code LogLayout} for
 * the lines, and Logback's own writer thread. {@link tellosimulator.log.StandardErrorLog} redirects
 * the output of libraries. Only this package depends on Logback; all other code logs through SLF4J.
 * Deciding what to log is not its job; see {@code HeadlessSimulator}.
 */
package tellosimulator.log;
