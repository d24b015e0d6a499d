/**
 * Tests of the distributed programs, and of the files that are used for their distribution.
 *
 * <p>{@code ReleaseFilesTest} compares versions and names in the repository's files with those of
 * {@code pom.xml}. {@code LicensesIT} and {@code AllSystemsIT} inspect the programs that Maven has
 * built, and run in its {@code verify}. It may import {@code json}, and no other package of the
 * simulator.
 */
package tellosimulator.release;
