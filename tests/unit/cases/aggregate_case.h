/* The size and the dimensions of an aggregate, by its places in the order in which they came. */
#ifndef FROND_AGGREGATE_CASE_H
#define FROND_AGGREGATE_CASE_H

typedef double place[3];

/* Of the first `count`. */
double aggregate_gyration(place *places, int count);
/* In the plane of x and y, within 1024 cells about the origin: boxes of 2 to 16 cells. */
double aggregate_box_dimension(place *places, int count);
/* Growth: the slope of ln n over ln Rg from `from` places to all. */
double aggregate_growth_dimension(place *places, int count, int from);
/* Mass: the slope of ln N(r) over ln r about the first place, from r = most / 8 to most / 2, where most is the distance
 * of the farthest: the inside alone, which is full-grown. */
double aggregate_mass_dimension(place *places, int count);

#endif
