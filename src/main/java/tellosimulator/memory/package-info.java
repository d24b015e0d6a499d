/**
 * How much memory the process keeps.
 *
 * <p>{@link tellosimulator.memory.ProcessMemory} tells the running Java machine what a jar cannot
 * say on its command line. The package imports {@code concurrent} and {@code time}. What the
 * program itself keeps, such as textures, is not its job.
 */
package tellosimulator.memory;
