/**
 * The log on standard error.
 *
 * <p>{@link tellosimulator.log.LogSetup} configures Logback: a queue, {@code LogLayout} for the
 * lines, and a thread of Logback's that writes. {@link tellosimulator.log.StandardErrorLog}
 * redirects what libraries print. Only this package knows Logback; everything else logs through
 * SLF4J. What is logged is not its job: see {@code EventLog} of {@code headless}.
 */
package tellosimulator.log;
