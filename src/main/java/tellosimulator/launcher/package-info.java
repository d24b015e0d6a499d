/**
 * Runs unmodified operator programs against a simulator, in a private network where the simulated
 * drones have the addresses of real ones. {@link tellosimulator.launcher.ProgramRun} is the main
 * type. It works on the calling thread and starts system processes, which is possible only on
 * Linux. Simulating drones and their traffic is not its job.
 */
package tellosimulator.launcher;
