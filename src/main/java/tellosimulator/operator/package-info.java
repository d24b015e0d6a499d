/**
 * Runs other people's operator programs, unchanged, against a simulator in a private network in
 * which drones have the addresses of real ones. {@link tellosimulator.operator.ProgramRun} is the
 * main type. It works on the calling thread, and starts processes of the system (Linux alone has
 * what it needs); what flies and what is on the wire is not its job.
 */
package tellosimulator.operator;
