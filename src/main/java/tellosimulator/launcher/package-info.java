/**
 * Runs unmodified operator programs against a simulator, such that the simulated drones have the
 * addresses of real ones: in a private network on Linux, or with a shim in the program elsewhere.
 * {@link tellosimulator.launcher.ProgramRun} is the main type. It works on the calling thread and
 * starts system processes. Simulating drones and their traffic is not its job.
 */
package tellosimulator.launcher;
